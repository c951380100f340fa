// SPDX-License-Identifier: BSD-3-Clause
#include "octree/octree.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/octree/random_trees.h"

namespace octet {
namespace {

using test::random_tree;

TEST(Octree, FindsTheOctantThatHoldsAPoint) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Octree tree = random_tree(seed);
    for (int i = 0; i < 1000; ++i) {
      const double x = share(random), y = share(random), z = share(random);
      const Vec3 p = tree.origin() + tree.root_size() * Vec3(x, y, z);
      EXPECT_TRUE(tree.box(tree.find(p)).contains(p));
    }
  }
}

TEST(Octree, FindsEveryOctantByItsCornersAndLastCell) {
  const Octree tree = random_tree(6);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Octant& o = tree[OctantId(i)];
    const std::uint32_t e = o.extent() - 1;
    EXPECT_EQ(tree.find(o.corner), OctantId(i));
    EXPECT_EQ(tree.find(Lattice{o.corner[0] + e, o.corner[1] + e, o.corner[2] + e}), OctantId(i));
    EXPECT_EQ(tree.find(tree.box(OctantId(i)).lo), OctantId(i));
  }
}

TEST(Octree, ClampsPointsOutsideTheRoot) {
  const Octree tree = random_tree(7);
  EXPECT_EQ(tree.find(Vec3(-100.0, -100.0, -100.0)), OctantId(0));
  EXPECT_EQ(tree.find(Vec3(100.0, 100.0, 100.0)), OctantId(tree.size() - 1));
}

TEST(Octree, RefineSplitsWhatIsAskedAndStaysBalanced) {
  Octree tree = random_tree(8, 5, 4);
  std::mt19937 random(9);
  for (int round = 0; round < 6; ++round) {
    const OctantId chosen(random() % tree.size());
    const Octant o = tree[chosen];
    const std::size_t before = tree.size();
    tree = refine(tree, std::array{chosen, chosen});
    EXPECT_EQ(check_octree(tree), "");
    EXPECT_GE(tree.size(), before + 7);
    EXPECT_EQ(tree[tree.find(o.corner)].level, o.level + 1);
  }
}

TEST(Octree, RefineLeavesOctantsOfTheFinestLevel) {
  Octree tree(Vec3::Zero(), 1.0, {Octant{}});
  for (int level = 0; level < kDeepestLevel; ++level) tree = refine(tree, std::array{OctantId(0)});
  EXPECT_EQ(tree[OctantId(0)].level, kDeepestLevel);
  EXPECT_EQ(refine(tree, std::array{OctantId(0)}).size(), tree.size());
  EXPECT_EQ(check_octree(tree), "");
}

TEST(CheckOctree, TellsGapsDisorderAndSteepSteps) {
  const Octree good = random_tree(10);
  std::vector<Octant> octants(good.octants().begin(), good.octants().end());
  EXPECT_EQ(check_octree(good), "");
  {
    std::vector<Octant> bad(octants.begin(), octants.begin() + 3);
    bad.insert(bad.end(), octants.begin() + 4, octants.end());
    EXPECT_NE(check_octree(Octree(Vec3::Zero(), 1.0, bad)), "");
  }
  {
    auto bad = octants;
    std::swap(bad[2], bad[3]);
    EXPECT_NE(check_octree(Octree(Vec3::Zero(), 1.0, bad)), "");
  }
  {
    auto bad = octants;
    bad.pop_back();
    EXPECT_NE(check_octree(Octree(Vec3::Zero(), 1.0, bad)), "");
  }
  {  // the root split once, then its first child's last child split twice more
    SplitKeys steep;
    steep.at[0] = {0};
    steep.at[1] = {0};
    steep.at[2] = {7};
    steep.at[3] = {63};
    EXPECT_NE(check_octree(Octree(Vec3::Zero(), 1.0, terminal_octants(steep))), "");
  }
}

}  // namespace
}  // namespace octet
