// SPDX-License-Identifier: BSD-3-Clause
// How far curves on faces are from their edges, and tolerances that cover no more than that.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

/// Largest distance (mm) of an edge's curve on a face from its curve in space at equal parameter, by samples;
/// 0 where either is missing.
[[nodiscard]] double curve_gap(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// The largest of all edges of a shape on its faces.
[[nodiscard]] double widest_curve_gap(const TopoDS_Shape& shape);

/// Gives edges of a solid, whose curves have become nearer, the tolerance that their curves need, and
/// their vertices what the edges there need.
void lower_tolerances(const TopoDS_Shape& solid, const std::vector<TopoDS_Edge>& edges);

}  // namespace octet
