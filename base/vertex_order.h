// SPDX-License-Identifier: BSD-3-Clause
// The one symbolic order of all points that breaks every tie of the Delaunay triangulation.
#pragma once

#include <bit>
#include <cstdint>

namespace octet {

/// Levels below the root of the finest lattice of octree vertices; coordinates are 0..2^kLatticeLevels.
inline constexpr int kLatticeLevels = 18;

/// Rank of an octree vertex at lattice coordinates (i, j, k), each in 0..2^kLatticeLevels, whose finest
/// terminal octant has level `finest_level` (root = 0): 2*level + whether an odd number of its
/// coordinates at that level are odd, then the coordinates. A larger rank is a larger symbolic weight.
/// It yields alternating diagonals, five tetrahedra in every plain octant (docs/ARCHITECTURE.md).
/// All octree vertices rank above all other points.
[[nodiscard]] constexpr std::uint64_t octree_vertex_rank(int finest_level, std::uint32_t i, std::uint32_t j,
                                                         std::uint32_t k) {
  const int shift = kLatticeLevels - finest_level;
  const std::uint64_t parity = ((i >> shift) ^ (j >> shift) ^ (k >> shift)) & 1u;
  const std::uint64_t head = 2u * static_cast<std::uint64_t>(finest_level) + parity;
  constexpr int kBits = kLatticeLevels + 1;
  static_assert(3 * kBits + 6 <= 63);
  return (std::uint64_t{1} << 63) | (head << (3 * kBits)) | (std::uint64_t{i} << (2 * kBits)) |
         (std::uint64_t{j} << kBits) | k;
}

/// Rank of the n-th point that is not an octree vertex.
[[nodiscard]] constexpr std::uint64_t free_point_rank(std::uint64_t n) { return n; }

}  // namespace octet
