// SPDX-License-Identifier: BSD-3-Clause
// Each level's split octants are spread over the level above, axis by axis, from the finest up.
#include "octree/gradation.h"

#include <algorithm>
#include <cmath>

#include "base/sort_unique.h"

namespace octet {
namespace {

/// The keys of a level and those up to `reach` octants beside them along each axis, as far as the root goes.
void spread(std::vector<MortonKey>& keys, int level, std::uint32_t reach) {
  const std::uint32_t end = std::uint32_t{1} << level;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t given = keys.size();
    for (std::size_t i = 0; i < given; ++i) {
      Lattice p = lattice_of(keys[i]);
      const std::uint32_t at = p[axis];
      for (std::uint32_t q = at - std::min(at, reach); q <= at + reach && q < end; ++q) {
        p[axis] = q;
        if (q != at) keys.push_back(morton_key(p));
      }
    }
    sort_unique(keys);
  }
}

}  // namespace

// A split octant of level l has children of length e; within `layers` octants of length 2 e around it nothing
// may be longer than 2 e. Those octants have level l, so their parents, up to (layers + 1) / 2 of them beside
// the octant's own parent, must be split.
SplitKeys graded(SplitKeys splits, int layers) {
  if (layers <= 1) return splits;
  const auto reach = static_cast<std::uint32_t>((layers + 1) / 2);
  for (int level = kLatticeLevels - 1; level > 0; --level) {
    std::vector<MortonKey> parents;
    for (const MortonKey key : splits.at[level]) parents.push_back(key >> 3);
    sort_unique(parents);
    spread(parents, level - 1, reach);
    std::vector<MortonKey>& above = splits.at[level - 1];
    above.insert(above.end(), parents.begin(), parents.end());
    sort_unique(above);
  }
  return splits;
}

int layers_of_growth(double growth) {
  constexpr int kMost = 16;
  return std::clamp(static_cast<int>(std::lround(std::log(2.0) / std::log(growth))), 1, kMost);
}

}  // namespace octet
