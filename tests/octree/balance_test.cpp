// SPDX-License-Identifier: BSD-3-Clause
#include "octree/balance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/octree/random_trees.h"

namespace octet {
namespace {

using test::random_splits;

TEST(Balance, NoNeighboursDifferByMoreThanOneLevel) {
  for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(check_octree(test::random_tree(seed)), "");
}

TEST(Balance, OneDeepOctantIsSurroundedByRings) {
  SplitKeys splits;
  splits.at[6].push_back((MortonKey{1} << 18) / 3);
  const Octree tree(Vec3::Zero(), 1.0, terminal_octants(balanced(splits)));
  EXPECT_EQ(check_octree(tree), "");
  EXPECT_EQ(std::ranges::max(tree.octants(), {}, &Octant::level).level, 7);
}

TEST(Balance, KeepsAllSplitsAsked) {
  const SplitKeys asked = random_splits(7, 60, 8);
  const SplitKeys result = balanced(asked);
  for (int level = 0; level < kLatticeLevels; ++level) {
    for (const MortonKey key : asked.at[level]) {
      EXPECT_TRUE(std::ranges::binary_search(result.at[level], key));
    }
  }
}

TEST(Balance, IsTheSmallestClosure) {
  // Taking any one split octant away that was not asked for breaks the closure, or one of its neighbours'.
  const SplitKeys asked = random_splits(8, 4, 5);
  const SplitKeys result = balanced(asked);
  for (int level = 0; level + 1 < kLatticeLevels; ++level) {
    for (const MortonKey key : result.at[level]) {
      if (std::ranges::find(asked.at[level], key) != asked.at[level].end()) continue;
      SplitKeys fewer = result;
      std::erase(fewer.at[level], key);
      EXPECT_EQ(balanced(fewer).at, result.at);
    }
  }
}

TEST(Balance, IsIdempotentAndIgnoresTheOrderOfItsInput) {
  SplitKeys asked = random_splits(9, 50, 7);
  const SplitKeys once = balanced(asked);
  EXPECT_EQ(balanced(once).at, once.at);
  for (auto& keys : asked.at) std::ranges::reverse(keys);
  EXPECT_EQ(balanced(asked).at, once.at);
}

TEST(Balance, SplitKeysAndTerminalOctantsAreInverse) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SplitKeys splits = balanced(random_splits(seed, 40, 7));
    const std::vector<Octant> octants = terminal_octants(splits);
    EXPECT_EQ(octants.size(), splits.terminal_count());
    EXPECT_EQ(split_keys(octants).at, splits.at);
  }
  EXPECT_EQ(terminal_octants(SplitKeys{}).size(), 1u);
}

}  // namespace
}  // namespace octet
