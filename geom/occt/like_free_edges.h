// SPDX-License-Identifier: BSD-3-Clause
// Free edges that sewing leaves beside each other.
#pragma once

#include <BRepTools_ReShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>

namespace octet {

/// Puts one edge in the place of both, in `changes`, for every two free edges (geom/occt/free_edges) of the
/// shape that have their vertices in common and run beside each other within `near` (mm) all along; of one
/// face only where they are its seam. OCCT's sewing joins the vertices and leaves such edges now and then, as
/// those beside the seam of a ball, and seams of surfaces that close but for rounding. Returns how many pairs
/// there were.
[[nodiscard]] std::size_t join_like_free_edges(const TopoDS_Shape& shape, double near,
                                               BRepTools_ReShape& changes);

}  // namespace octet
