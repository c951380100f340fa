// SPDX-License-Identifier: BSD-3-Clause
// Edges where a shell is open.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Edges that one face of the shape uses, and only once; edges without length do not count.
[[nodiscard]] std::vector<TopoDS_Edge> free_edges(const TopoDS_Shape& shape);

/// Points along an edge in the direction of its curve, both ends among them, `pieces` + 1 evenly by
/// parameter; none where it has no curve.
[[nodiscard]] std::vector<Vec3> points_along(const TopoDS_Edge& edge, int pieces);

}  // namespace octet
