// SPDX-License-Identifier: BSD-3-Clause
// The hierarchy over boxes against brute force.
#include "geom/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

std::vector<std::uint32_t> within(const BoxTree& tree, const Vec3& p, double radius) {
  std::vector<std::uint32_t> found;
  tree.visit_within(p, radius, [&](std::uint32_t box) { found.push_back(box); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxTree, FindsWhatIsNearAndNothingElse) {
  Dice dice(11);
  const Vec3 lo(-1.0, -1.0, -1.0), hi(1.0, 1.0, 1.0);
  for (const std::size_t count : {1u, 2u, 7u, 500u}) {
    std::vector<Box3> boxes(count);
    for (Box3& box : boxes) {
      box.add(dice.vec(lo, hi));
      box.add(box.lo + dice(0.0, 0.3) * dice.vec({0.0, 0.0, 0.0}, hi));
    }
    const BoxTree tree(boxes);
    std::size_t met = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = dice.vec(1.5 * lo, 1.5 * hi);
      const double radius = dice(0.0, 0.8);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t b = 0; b < count; ++b)
        if (boxes[b].squared_distance(p) <= radius * radius) expected.push_back(b);
      ASSERT_EQ(within(tree, p, radius), expected);
      met += expected.size();
    }
    EXPECT_GT(met, 0u);
  }
}

TEST(BoxTree, BoxesInOnePlaceAndEmptyOnes) {
  std::vector<Box3> boxes(100);
  for (std::size_t i = 0; i < 100; i += 2) boxes[i].add(Vec3(1.0, 2.0, 3.0));
  const BoxTree tree(boxes);
  EXPECT_EQ(within(tree, {1.0, 2.0, 3.5}, 0.5).size(), 50u);
  EXPECT_TRUE(within(tree, {1.0, 2.0, 3.5}, 0.4).empty());
  EXPECT_TRUE(within(BoxTree(), {0.0, 0.0, 0.0}, 1.0).empty());
  EXPECT_TRUE(within(BoxTree(std::vector<Box3>(3)), {0.0, 0.0, 0.0}, 1.0).empty());
}

}  // namespace
}  // namespace octet
