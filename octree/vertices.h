// SPDX-License-Identifier: BSD-3-Clause
// The points of an octree: each lattice point that is a corner of a terminal octant, once, and the centres.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "octree/octree.h"

namespace octet {

/// No vertex there.
inline constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

/// Corners first, sorted by the Morton key of the lattice point; then the centre of each octant, in their
/// order. `finest_level` is that of the finest terminal octant that has the vertex as a corner or centre.
struct OctreeVertices {
  std::vector<Lattice> at;
  std::vector<std::int8_t> finest_level;
  std::vector<std::array<std::uint32_t, 8>> corners;  ///< per octant: its corners' vertex numbers, x fastest
  /// A vertex that hangs on an octant's edge or face, and its place on the octant's 3x3x3 lattice.
  struct Hanging {
    std::uint32_t vertex = 0;
    std::uint32_t place = 0;
  };
  std::vector<Hanging> hanging;              ///< octant by octant, by place
  std::vector<std::uint32_t> hanging_begin;  ///< per octant, and the end

  [[nodiscard]] std::size_t size() const { return at.size(); }
  /// Vertices below this number are corners.
  [[nodiscard]] std::size_t corner_count() const { return at.size() - corners.size(); }
  [[nodiscard]] std::uint32_t centre(OctantId o) const {
    return static_cast<std::uint32_t>(corner_count() + o.index());
  }
  [[nodiscard]] std::span<const Hanging> hanging_on(OctantId o) const {
    return std::span(hanging).subspan(hanging_begin[o.index()],
                                      hanging_begin[o.index() + 1] - hanging_begin[o.index()]);
  }
  /// Number of the corner at `p`, or UINT32_MAX. O(log n).
  [[nodiscard]] std::uint32_t find(const Lattice& p) const;
  [[nodiscard]] std::uint64_t rank(std::uint32_t v) const {
    return octree_vertex_rank(at[v][0], at[v][1], at[v][2]);
  }
};

/// Cost: O(n) where the tree is uniform; only hanging vertices and those on the root's far faces are sorted.
/// Memory: about 62 bytes an octant, and 8 for each vertex that hangs on it.
[[nodiscard]] OctreeVertices octree_vertices(const Octree& tree);

/// The vertices on the 3x3x3 lattice of an octant, x fastest: its corners, its centre, and the hanging
/// vertices on its edges and faces; kNoVertex elsewhere.
using OctantLattice = std::array<std::uint32_t, 27>;
[[nodiscard]] OctantLattice octant_lattice(const OctreeVertices& vertices, OctantId octant);

/// visit(vertex) for the same vertices, in no particular order.
template <class Visit>
void for_each_vertex(const OctreeVertices& vertices, OctantId octant, const Visit& visit) {
  visit(vertices.centre(octant));
  for (const std::uint32_t v : vertices.corners[octant.index()]) visit(v);
  for (const OctreeVertices::Hanging& h : vertices.hanging_on(octant)) visit(h.vertex);
}

/// Sets the flags of these vertices. Octants that touch each other share a vertex, for the finer one's
/// corners are all on the coarser one's lattice: such flags find neighbours without searching.
inline void flag_vertices(const OctreeVertices& vertices, OctantId octant, std::vector<std::uint8_t>& flags) {
  for_each_vertex(vertices, octant, [&](std::uint32_t v) { flags[v] = 1; });
}

}  // namespace octet
