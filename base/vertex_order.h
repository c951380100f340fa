// SPDX-License-Identifier: BSD-3-Clause
// The one symbolic order of all points that breaks every tie of the Delaunay triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace octet {

/// Levels below the root of the finest lattice of octree vertices; coordinates are 0..2^kLatticeLevels.
inline constexpr int kLatticeLevels = 18;

/// Ranks with the same bits from here up are of one class: equal weights, so long as that decides.
inline constexpr int kRankClassShift = 57;

/// Rank of an octree vertex at lattice coordinates (i, j, k), each in 0..2^kLatticeLevels. Its class is
/// 2*level + parity, where `level` is the coarsest level whose lattice holds the vertex (root = 0) and
/// `parity` is whether an odd number of its coordinates at that level are odd; within a class come the
/// coordinates. A larger class is a larger symbolic weight. In a cube of octree vertices whose centre is no
/// point, as beside the boundary, the four corners that are odd at its level then outweigh the other four,
/// equally: alternating diagonals, whatever its neighbours are (docs/ARCHITECTURE.md). The rank depends on
/// the place alone, so it outlives refinement. All octree vertices rank above all other points.
[[nodiscard]] constexpr std::uint64_t octree_vertex_rank(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const std::uint32_t any = i | j | k;
  const int shift = any == 0 ? kLatticeLevels : std::min(kLatticeLevels, std::countr_zero(any));
  const std::uint64_t parity = ((i >> shift) ^ (j >> shift) ^ (k >> shift)) & 1u;
  const std::uint64_t head = 2u * static_cast<std::uint64_t>(kLatticeLevels - shift) + parity;
  constexpr int kBits = kLatticeLevels + 1;
  static_assert(3 * kBits <= kRankClassShift && 2 * kLatticeLevels + 1 < 64);
  return (std::uint64_t{1} << 63) | (head << kRankClassShift) | (std::uint64_t{i} << (2 * kBits)) |
         (std::uint64_t{j} << kBits) | k;
}

/// The lattice coordinates in the rank of an octree vertex.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> octree_vertex_lattice(std::uint64_t rank) {
  constexpr int kBits = kLatticeLevels + 1;
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;
  return {static_cast<std::uint32_t>(rank >> (2 * kBits) & kMask),
          static_cast<std::uint32_t>(rank >> kBits & kMask), static_cast<std::uint32_t>(rank & kMask)};
}

/// Whether this is the rank of an octree vertex.
[[nodiscard]] constexpr bool is_octree_vertex_rank(std::uint64_t rank) { return rank >> 63 != 0; }

/// Rank of the n-th point that is not an octree vertex.
[[nodiscard]] constexpr std::uint64_t free_point_rank(std::uint64_t n) { return n; }

}  // namespace octet
