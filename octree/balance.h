// SPDX-License-Identifier: BSD-3-Clause
// The one-level difference over 26 neighbours, as a pure function on sorted keys.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "octree/octant.h"

namespace octet {

/// A tree told by the octants that are split: at[l] holds the keys of the split octants of level l. All
/// others are terminal or absent.
struct SplitKeys {
  std::array<std::vector<MortonKey>, kLatticeLevels> at;

  /// Terminal octants of the tree, when the keys are unique and closed under parents.
  [[nodiscard]] std::size_t terminal_count() const;
};

/// The smallest superset that is sorted, unique, closed under parents, and in which octants that share a
/// face, an edge or a corner differ by at most one level. The smallest such tree is unique, so the order of
/// the input does not matter. Cost: O(n log n) over the split octants, an eighth of the terminal ones.
[[nodiscard]] SplitKeys balanced(SplitKeys splits);

/// The terminal octants in Morton order. Requires: sorted, unique, closed under parents.
[[nodiscard]] std::vector<Octant> terminal_octants(const SplitKeys& splits);

/// The inverse: the split octants of a tree that covers the root, sorted.
[[nodiscard]] SplitKeys split_keys(std::span<const Octant> sorted);

}  // namespace octet
