// SPDX-License-Identifier: BSD-3-Clause
// Faces whose splines are planes, cylinders or cones, on planes, cylinders and cones.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// An edge, forward, and its curves on a face: of a seam there are two.
struct CurveOnFace {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) curve, back;
  double t0 = 0.0, t1 = 0.0;
};

/// A face that was put on its closed form.
struct ClosedForm {
  struct Side {
    Handle(Geom_Surface) surface;
    TopLoc_Location place;
    std::vector<CurveOnFace> curves;  ///< of all edges; null on planes
  };
  TopoDS_Face face;
  Side was, is;
};

/// Puts faces whose splines, extrusions and so on are planes, cylinders or cones (geom/recognise) on these,
/// in place, and gives their edges curves on them: OCCT intersects these by formulas, and splines by marching
/// along what they have in common, which takes many times as long and fails for some. (Spheres and tori: an
/// assembly took twice as long with them as with their splines.) Edges stay as they are in space. A face
/// stays a spline where a new curve, or on planes an edge, would be farther off than the edge's tolerance
/// allows. Returns those that changed.
[[nodiscard]] std::vector<ClosedForm> give_closed_forms(const std::vector<TopoDS_Shape>& solids);

/// Puts the faces on what they were on before, with the curves of then.
void take_back(const std::vector<ClosedForm>& forms);

}  // namespace octet
