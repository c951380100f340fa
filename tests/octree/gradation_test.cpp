// SPDX-License-Identifier: BSD-3-Clause
// Slower growth than the one-level difference.
#include "octree/gradation.h"

#include <gtest/gtest.h>

#include "octree/octree.h"
#include "tests/octree/random_trees.h"

namespace octet {
namespace {

Octree tree_of(const SplitKeys& splits) {
  return Octree(Vec3::Zero(), 1.0, terminal_octants(balanced(splits)));
}

TEST(Gradation, OneLayerChangesNothing) {
  const SplitKeys splits = test::random_splits(3, 40, 7);
  EXPECT_EQ(graded(splits, 1).at, splits.at);
}

TEST(Gradation, LayersOfALevelAreAsManyAsAskedFor) {
  for (const int layers : {2, 3, 5}) {
    const Octree tree = tree_of(graded(test::random_splits(5, 6, 7), layers));
    EXPECT_EQ(check_octree(tree), "");
    for (std::size_t i = 0; i < tree.size(); ++i) {
      const Box3 box = tree.box(OctantId(i));
      const double length = box.size().x(), reach = 2.0 * length * layers;
      // Along the axes, both ways, within the root: nothing longer than twice this octant.
      for (int axis = 0; axis < 3; ++axis)
        for (double s = -reach; s <= reach; s += length) {
          Vec3 p = box.centre();
          p[axis] += s < 0.0 ? s - 0.4 * length + length : s + 0.4 * length - length;
          if (p[axis] <= 0.0 || p[axis] >= 1.0) continue;
          EXPECT_LE(tree.length_at(p), 2.0 * length * (1.0 + 1e-12)) << layers;
        }
    }
  }
}

TEST(Gradation, LayersFollowFromGrowth) {
  EXPECT_EQ(layers_of_growth(2.0), 1);
  EXPECT_EQ(layers_of_growth(1.41), 2);
  EXPECT_EQ(layers_of_growth(1.26), 3);
  EXPECT_EQ(layers_of_growth(1.1), 7);
}

}  // namespace
}  // namespace octet
