// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of one block of space, found without the rest of the triangulation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "delaunay/point_index.h"

namespace octet {

struct BlockTets {
  /// Numbers of the points of the whole; positive, the smallest number first, sorted.
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::size_t gathered = 0;  ///< points triangulated in the last round
  int rounds = 0;            ///< 1 when the first halo was wide enough
};

/// Exactly those tetrahedra of the triangulation of all points whose vertex of largest rank lies in the
/// block: lo <= p < hi, and p = hi where the block ends with the whole. Blocks that tile space so give each
/// tetrahedron of the whole once, whoever computes them, in whatever order.
///
/// Gathers the points of the block grown by `halo` and triangulates them. The star of a vertex is that of the
/// whole when all its spheres lie in the gathered region, and beyond its hull facets there is nothing; else
/// the halo is doubled, at last to all points. Requires: distinct points, distinct ranks. Throws InputError
/// when all points lie in one plane. Thread-safe.
[[nodiscard]] BlockTets block_tets(const PointIndex& all, std::span<const std::uint64_t> ranks,
                                   const Box3& block, double halo);

}  // namespace octet
