// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces that were converted to splines, which OCCT makes amiss.
#pragma once

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace octet {

/// Gives `made`, an edge of `made_face`, the curve that `edge` has on `face`, whose parameters are about the
/// same, fitted to the edge; edges and faces forward. A seam gets both of its curves, or where the face ends
/// at it, and the other lies beyond, the one that it has. Standard_Failure: there is none.
void carry_curve(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Edge& made,
                 const TopoDS_Face& made_face);

/// Fits curves on the faces that were made of a solid's anew, in place, where they run more than `noise` (mm)
/// beside their edges: those that OCCT begins on one side of a seam and goes on with from the other are
/// carried over from the old faces.
void mend_conversion(const TopoDS_Shape& solid, BRepBuilderAPI_NurbsConvert& convert, double noise);

/// Gives edges of a solid no more tolerance than `allowed` (mm): OCCT may give one the size of its face,
/// whatever its curves are. False, and nothing is done, where a curve on a face is farther off its edge.
[[nodiscard]] bool lower_tolerances_to(const TopoDS_Shape& solid, double allowed);

}  // namespace octet
