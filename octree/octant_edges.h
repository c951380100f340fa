// SPDX-License-Identifier: BSD-3-Clause
// The edges of boundary octants, each once, at the finest granularity.
#pragma once

#include <vector>

#include "octree/octant_types.h"
#include "octree/vertices.h"

namespace octet {

/// An octant edge that no hanging vertex splits: from < to along its axis.
struct OctantEdge {
  std::uint32_t from = 0, to = 0;  ///< octree vertex numbers
  auto operator<=>(const OctantEdge&) const = default;
};

/// All edges of boundary octants, sorted by (from, to), unique; an edge with a hanging vertex is told as its
/// two halves. Cost: O(n log n) over the boundary octants.
[[nodiscard]] std::vector<OctantEdge> boundary_octant_edges(const Octree& tree,
                                                            const OctreeVertices& vertices,
                                                            const OctantTypes& types);

}  // namespace octet
