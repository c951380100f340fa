// SPDX-License-Identifier: BSD-3-Clause
// The exact cuts of octant edges with the model's boundary.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geom/model.h"
#include "octree/octant_edges.h"

namespace octet {

/// A cut of one octant edge: each geometric edge of the tree's finest terminal octants is cut once, however
/// many octants share it.
struct OctantEdgeCut {
  std::uint32_t from = 0, to = 0;  ///< octree vertex numbers, from < to
  Hit hit;
};

/// All cuts of `edges`, those of boundary_octant_edges(), in their order, by t on each [Handbook 15.5.2.2].
/// Long edges that a hanging vertex splits are cut by their halves only. Edges are cut in parallel.
/// `cancelled` is asked often by the calling thread; true ends the search with Cancelled.
[[nodiscard]] std::vector<OctantEdgeCut> cut_octant_edges(const Model& model, const Octree& tree,
                                                          const OctreeVertices& vertices,
                                                          std::span<const OctantEdge> edges,
                                                          const std::function<bool()>& cancelled = {});

}  // namespace octet
