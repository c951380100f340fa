// SPDX-License-Identifier: BSD-3-Clause
// The lattice edges of boundary octants, each once, at the finest granularity.
#pragma once

#include <vector>

#include "octree/octant_types.h"
#include "octree/vertices.h"

namespace octet {

/// A line of the body-centred lattice: an octant edge that no hanging vertex splits, or a line from a centre
/// to a corner, or to the centre of an octant of the same length across a face. From < to.
struct OctantEdge {
  std::uint32_t from = 0, to = 0;  ///< numbers of octree vertices
  auto operator<=>(const OctantEdge&) const = default;
};

/// All such lines of boundary octants, unique; an edge with a hanging vertex is told as its two halves. First
/// those along the axes, sorted by (from, to), then the diagonals octant by octant: points that are taken in
/// this order lie in rows on planes along the axes, which saved two thirds of a box's finalization. Cost:
/// O(n) over the octants.
[[nodiscard]] std::vector<OctantEdge> boundary_octant_edges(const Octree& tree,
                                                            const OctreeVertices& vertices,
                                                            const OctantTypes& types);

}  // namespace octet
