// SPDX-License-Identifier: BSD-3-Clause
// Solids whose boundary crosses itself, as files have them.
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>

#include <array>
#include <cmath>
#include <vector>

#include "geom/occt/shape_measures.h"

namespace octet::test {

inline TopoDS_Shape box_between(const gp_Pnt& a, const gp_Pnt& b) {
  return BRepPrimAPI_MakeBox(a, b).Shape();
}

/// One solid of one shell with the faces of all the shapes.
inline TopoDS_Shape one_shell_of(const std::vector<TopoDS_Shape>& shapes) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) builder.Add(shell, it.Current());
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// Two boxes of side 10, one 5 farther along each axis: together 1875.
inline TopoDS_Shape crossed_boxes() {
  return one_shell_of({box_between({0, 0, 0}, {10, 10, 10}), box_between({5, 5, 5}, {15, 15, 15})});
}

/// The faces of a solid, which share no edges, sewn and turned outward.
inline TopoDS_Shape sewn_solid(const std::vector<TopoDS_Shape>& faces) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const TopoDS_Shape& face : faces) sewing.Add(face);
  sewing.Perform();
  TopoDS_Solid solid;
  const BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL).Current());
  return volume_of(solid) < 0.0 ? solid.Reversed() : TopoDS_Shape(solid);
}

/// A pin of radius r and straight ends of length 5, bent by a right angle about the z axis at distance R: for
/// R < r the bend's torus goes through its own axis, and the straight ends cross there.
inline TopoDS_Shape bent_pin(double r, double bend) {
  const double quarter = 2.0 * std::atan(1.0), whole = 4.0 * quarter;
  const auto disc = [&](const gp_Ax2& axes) {
    return BRepBuilderAPI_MakeFace(
               BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, r)).Edge()).Wire(), true)
        .Shape();
  };
  const gp_Ax2 start(gp_Pnt(bend, -5.0, 0.0), gp::DY(), gp::DX()),
      end(gp_Pnt(-5.0, bend, 0.0), -gp::DX(), gp::DY()), middle(gp_Pnt(bend, 0.0, 0.0), gp::DY(), gp::DX());
  const Handle(Geom_Surface) turn =
      new Geom_SurfaceOfRevolution(new Geom_Circle(gp_Circ(middle, r)), gp_Ax1(gp::Origin(), gp::DZ()));
  return sewn_solid({disc(start), disc(end),
                     BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(start), r), 0.0, whole, 0.0, 5.0).Shape(),
                     BRepBuilderAPI_MakeFace(turn, 0.0, quarter, 0.0, whole, 1e-7).Shape(),
                     BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(end), r), 0.0, whole, -5.0, 0.0).Shape()});
}

/// A plate 4 by 4, 1.5 high, with a chamfer at one corner that is 1 wide at the bottom, narrows to nothing at
/// the height 1 and goes on: there its sides and those of the top cross, and what is beyond is inside out.
inline TopoDS_Shape plate_with_a_bow_tie() {
  const auto face = [](const gp_Dir& normal, const std::vector<gp_Pnt>& corners) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& corner : corners) polygon.Add(corner);
    polygon.Close();
    return BRepBuilderAPI_MakeFace(gp_Pln(corners.front(), normal), polygon.Wire(), false).Shape();
  };
  constexpr double h = 1.5;
  return sewn_solid({face(-gp::DZ(), {{0, 0, 0}, {0, 4, 0}, {3, 4, 0}, {4, 3, 0}, {4, 0, 0}}),
                     face(gp::DZ(), {{0, 0, h}, {4, 0, h}, {4, 4.5, h}, {4.5, 4, h}, {0, 4, h}}),
                     face(-gp::DX(), {{0, 0, 0}, {0, 0, h}, {0, 4, h}, {0, 4, 0}}),
                     face(-gp::DY(), {{0, 0, 0}, {4, 0, 0}, {4, 0, h}, {0, 0, h}}),
                     face(gp::DX(), {{4, 0, 0}, {4, 3, 0}, {4, 4.5, h}, {4, 0, h}}),
                     face(gp::DY(), {{3, 4, 0}, {0, 4, 0}, {0, 4, h}, {4.5, 4, h}}),
                     face(gp_Dir(1, 1, -1), {{4, 3, 0}, {3, 4, 0}, {4.5, 4, h}, {4, 4.5, h}})});
}

/// A wire of radius 1 along a path that comes back over itself, 0.7 higher than it went.
inline TopoDS_Shape looped_wire() {
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {20, 0, 0}, {20, 10, 0.7}, {10, 10, 0.7}, {10, -10, 0.7}};
  BRepBuilderAPI_MakeWire path;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    path.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[i + 1]).Edge());
  const gp_Circ section(gp_Ax2(corners[0], gp::DX()), 1.0);
  BRepOffsetAPI_MakePipeShell pipe(path.Wire());
  pipe.SetTransitionMode(BRepBuilderAPI_RightCorner);
  pipe.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section).Edge()).Wire());
  pipe.Build();
  pipe.MakeSolid();
  return pipe.Shape();
}

/// A round bar along a curve.
inline TopoDS_Shape bar_along(const Handle(Geom_Curve) & curve, double radius) {
  gp_Pnt start;
  gp_Vec way;
  curve->D1(curve->FirstParameter(), start, way);
  const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve));
  BRepOffsetAPI_MakePipeShell pipe(spine);
  pipe.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(start, way), radius))));
  pipe.Build();
  pipe.MakeSolid();
  return pipe.Shape();
}

/// A round bar along a spline whose bends have radii of 2 at the least: thicker ones fold there.
inline TopoDS_Shape folded_bar(double radius) {
  const Handle(TColgp_HArray1OfPnt) through = new TColgp_HArray1OfPnt(1, 6);
  const std::array<gp_Pnt, 6> places{gp_Pnt(0.22, -8.13, 0.0),   gp_Pnt(10.28, 12.75, 12.0),
                                     gp_Pnt(-8.48, -4.16, 24.0), gp_Pnt(-3.79, 0.49, 36.0),
                                     gp_Pnt(-2.09, 8.57, 48.0),  gp_Pnt(-6.44, 7.46, 60.0)};
  for (int i = 0; i < 6; ++i) through->SetValue(i + 1, places[i]);
  GeomAPI_Interpolate spine(through, false, 1e-7);
  spine.Perform();
  return bar_along(spine.Curve(), radius);
}

}  // namespace octet::test
