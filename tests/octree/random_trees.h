// SPDX-License-Identifier: BSD-3-Clause
// Small trees for tests, the same ones with every compiler.
#pragma once

#include <random>

#include "octree/balance.h"
#include "octree/octree.h"

namespace octet::test {

/// `n` octants split at random places, levels up to `finest`; not balanced.
inline SplitKeys random_splits(unsigned seed, int n, int finest) {
  std::mt19937 random(seed);
  SplitKeys splits;
  for (int i = 0; i < n; ++i) {
    const int level = static_cast<int>(random() % static_cast<unsigned>(finest));
    const MortonKey key = (MortonKey{random()} << 32 | random()) & ((MortonKey{1} << (3 * level)) - 1);
    splits.at[level].push_back(key);
  }
  return splits;
}

inline Octree random_tree(unsigned seed, int n = 40, int finest = 7) {
  return Octree(Vec3(-1.0, 0.5, 2.0), 4.0, terminal_octants(balanced(random_splits(seed, n, finest))));
}

/// All octants of one level.
inline Octree uniform_tree(int level) {
  SplitKeys splits;
  for (int l = 0; l < level; ++l) {
    for (MortonKey key = 0; key < MortonKey{1} << (3 * l); ++key) splits.at[l].push_back(key);
  }
  return Octree(Vec3::Zero(), 1.0, terminal_octants(splits));
}

}  // namespace octet::test
