// SPDX-License-Identifier: BSD-3-Clause
// The vertices of an octree: each lattice point that is a corner of a terminal octant, once.
#pragma once

#include <cstdint>
#include <vector>

#include "octree/octree.h"

namespace octet {

/// Sorted by (Morton key of the lattice point); `finest_level` is that of the finest terminal octant that has
/// the vertex as a corner, which is the level octree_vertex_rank() wants.
struct OctreeVertices {
  std::vector<Lattice> at;
  std::vector<std::int8_t> finest_level;
  std::vector<std::array<std::uint32_t, 8>> corners;  ///< per octant: its corners' vertex numbers, x fastest

  [[nodiscard]] std::size_t size() const { return at.size(); }
  /// Number of the vertex at `p`, or UINT32_MAX.
  [[nodiscard]] std::uint32_t find(const Lattice& p) const;
  [[nodiscard]] std::uint64_t rank(std::uint32_t v) const {
    return octree_vertex_rank(finest_level[v], at[v][0], at[v][1], at[v][2]);
  }
};

[[nodiscard]] OctreeVertices octree_vertices(const Octree& tree);

}  // namespace octet
