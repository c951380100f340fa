// SPDX-License-Identifier: BSD-3-Clause
// Closing a tree under the one-level difference, level by level from the finest.
//
// A split octant p of level l has children of level l+1, so every neighbour of p must exist as an octant of
// level l, terminal or split: the parents of p's 26 neighbours must be split. Nothing else is needed, because
// neighbours of a child lie within p and p's neighbours. One sweep from the finest level to the root
// suffices: what it adds at level l-1 is only asked about when the sweep gets there.
#include "octree/balance.h"

#include <algorithm>
#include <cstddef>

#include "base/sort_unique.h"

namespace octet {
namespace {

/// Which of the 27 octants around a parent (x fastest) hold a neighbour of each of its children: those
/// towards which the child lies, and the parent itself.
constexpr std::array<std::uint32_t, 8> neighbour_parents() {
  std::array<std::uint32_t, 8> mask{};
  for (int child = 0; child < 8; ++child) {
    for (int n = 0; n < 8; ++n) {
      int place = 0, stride = 1;
      for (int axis = 0; axis < 3; ++axis, stride *= 3) {
        const int towards = (child >> axis & 1) != 0 ? 2 : 0;
        place += stride * ((n >> axis & 1) != 0 ? towards : 1);
      }
      mask[child] |= 1u << place;
    }
  }
  return mask;
}

/// Appends the octants of level `level` around `parent` whose bit is set, as far as they lie in the root.
void append_around(MortonKey parent, std::uint32_t mask, int level, std::vector<MortonKey>& keys) {
  const Lattice at = lattice_of(parent);
  const std::uint32_t end = std::uint32_t{1} << level;
  for (std::uint32_t place = 0; place < 27; ++place) {
    if ((mask >> place & 1u) == 0) continue;
    // Below zero wraps to a large number, which is not below `end` either.
    const Lattice p{at[0] + place % 3 - 1, at[1] + place / 3 % 3 - 1, at[2] + place / 9 - 1};
    if (p[0] < end && p[1] < end && p[2] < end) keys.push_back(morton_key(p));
  }
}

void append_terminals(const SplitKeys& splits, std::array<std::size_t, kLatticeLevels>& next, MortonKey key,
                      int level, std::vector<Octant>& octants) {
  if (level < kLatticeLevels && next[level] < splits.at[level].size() &&
      splits.at[level][next[level]] == key) {
    ++next[level];
    for (MortonKey child = 0; child < 8; ++child) {
      append_terminals(splits, next, key << 3 | child, level + 1, octants);
    }
  } else {
    octants.push_back(octant_of(key, level));
  }
}

}  // namespace

std::size_t SplitKeys::terminal_count() const {
  std::size_t count = 1;
  for (const auto& keys : at) count += 7 * keys.size();
  return count;
}

SplitKeys balanced(SplitKeys splits) {
  constexpr auto kNeighbourParents = neighbour_parents();
  sort_unique(splits.at.back());
  for (int level = kLatticeLevels - 1; level > 0; --level) {
    const std::vector<MortonKey>& keys = splits.at[level];
    std::vector<MortonKey>& parents = splits.at[level - 1];
    for (std::size_t i = 0; i < keys.size();) {
      const MortonKey parent = keys[i] >> 3;
      std::uint32_t mask = 0;
      for (; i < keys.size() && keys[i] >> 3 == parent; ++i) mask |= kNeighbourParents[keys[i] & 7];
      append_around(parent, mask, level - 1, parents);
    }
    sort_unique(parents);
  }
  return splits;
}

std::vector<Octant> terminal_octants(const SplitKeys& splits) {
  std::vector<Octant> octants;
  octants.reserve(splits.terminal_count());
  // Depth first meets the split octants of each level in Morton order: one cursor a level is enough.
  std::array<std::size_t, kLatticeLevels> next{};
  append_terminals(splits, next, 0, 0, octants);
  return octants;
}

SplitKeys split_keys(std::span<const Octant> sorted) {
  SplitKeys splits;
  for (const Octant& o : sorted) {
    // Each split octant is met once: at the terminal octant in its lower corner.
    MortonKey key = morton_key(o.corner) >> (3 * (kLatticeLevels - o.level));
    for (int level = o.level; level > 0 && (key & 7) == 0; --level) {
      key >>= 3;
      splits.at[level - 1].push_back(key);
    }
  }
  return splits;
}

}  // namespace octet
