// SPDX-License-Identifier: BSD-3-Clause
// The curve on a face of an edge that has just come to it.
#pragma once

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace octet {

/// Whether the edge had no curve on the face and has one now; by OCCT's projection.
inline bool add_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0.0, last = 0.0;
  return BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull() &&
         ShapeFix_Edge().FixAddPCurve(edge, face, false, Precision::Confusion());
}

}  // namespace octet
