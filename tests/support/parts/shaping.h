// SPDX-License-Identifier: BSD-3-Clause
// What parts are made of: solids, sketches and the features of a CAD program. Where OCCT cannot do an
// operation, or what it gives is no valid solid, the shape stays as it was.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <functional>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "tests/support/parts/draw.h"

namespace octet::test {

/// Valid by BRepCheck_Analyzer, with a solid, none of whose volumes is 0 or less.
[[nodiscard]] bool is_sound(const TopoDS_Shape& shape);

/// What `change` makes of the shape, or the shape itself where that is not sound.
[[nodiscard]] TopoDS_Shape changed(const TopoDS_Shape& shape, const std::function<TopoDS_Shape()>& change);

[[nodiscard]] TopoDS_Shape box(const gp_Pnt& corner, double dx, double dy, double dz);
[[nodiscard]] TopoDS_Shape rod(const gp_Pnt& foot, const gp_Dir& along, double radius, double length);
[[nodiscard]] TopoDS_Shape frustum(const gp_Pnt& foot, const gp_Dir& along, double r1, double r2,
                                   double length);

[[nodiscard]] TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool);
[[nodiscard]] TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b);
[[nodiscard]] TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b);
/// Coplanar faces and edges in line made one, as CAD programs do.
[[nodiscard]] TopoDS_Shape unified(const TopoDS_Shape& shape);
[[nodiscard]] TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by);
[[nodiscard]] gp_Trsf turn(const gp_Ax1& about, double angle);
[[nodiscard]] gp_Trsf shift(double x, double y, double z);

[[nodiscard]] TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners, bool closed = true);
/// The face of a polygon in one plane, corners rounded with the radius where that goes.
[[nodiscard]] TopoDS_Face rounded_polygon(const std::vector<gp_Pnt>& corners, double radius);
[[nodiscard]] TopoDS_Shape extruded(const TopoDS_Shape& sketch, const gp_Vec& by);
/// About the z axis.
[[nodiscard]] TopoDS_Shape revolved(const TopoDS_Shape& sketch, double angle);

/// Some edges rounded or chamfered, all with one radius, one by one or all of a face; `share` of the edges.
[[nodiscard]] TopoDS_Shape blended(const TopoDS_Shape& shape, Draw& draw, double radius, double share);
/// Edges rounded with a radius that grows along them.
[[nodiscard]] TopoDS_Shape blended_unevenly(const TopoDS_Shape& shape, Draw& draw, double r1, double r2);
/// Hollow with the thickness, open at the face highest along z.
[[nodiscard]] TopoDS_Shape shelled(const TopoDS_Shape& shape, double thickness);
/// Walls along z leant by the angle, from the height up.
[[nodiscard]] TopoDS_Shape drafted(const TopoDS_Shape& shape, double angle, double height);

struct Extent {
  gp_Pnt low, high;
  [[nodiscard]] double x() const { return high.X() - low.X(); }
  [[nodiscard]] double y() const { return high.Y() - low.Y(); }
  [[nodiscard]] double z() const { return high.Z() - low.Z(); }
  [[nodiscard]] double least() const { return std::min({x(), y(), z()}); }
  [[nodiscard]] gp_Pnt middle() const { return {0.5 * (low.XYZ() + high.XYZ())}; }
};
[[nodiscard]] Extent extent_of(const TopoDS_Shape& shape);

}  // namespace octet::test
