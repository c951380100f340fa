// SPDX-License-Identifier: BSD-3-Clause
#include "octree/vertices.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/octree/random_trees.h"

namespace octet {
namespace {

using test::random_tree;

Lattice corner(const Octant& o, int c) {
  const std::uint32_t e = o.extent();
  return {o.corner[0] + (c & 1) * e, o.corner[1] + (c >> 1 & 1) * e, o.corner[2] + (c >> 2) * e};
}

TEST(OctreeVertices, AreTheCornersOfAllOctantsOnceThenTheCentres) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Octree tree = random_tree(seed);
    const OctreeVertices vertices = octree_vertices(tree);
    std::map<MortonKey, int> finest;
    for (const Octant& o : tree.octants()) {
      for (int c = 0; c < 8; ++c) {
        auto [it, is_new] = finest.try_emplace(morton_key(corner(o, c)), o.level);
        it->second = std::max<int>(it->second, o.level);
      }
    }
    ASSERT_EQ(vertices.corner_count(), finest.size());
    ASSERT_EQ(vertices.size(), finest.size() + tree.size());
    std::size_t v = 0;
    for (const auto& [key, level] : finest) {  // Morton order, as promised
      EXPECT_EQ(morton_key(vertices.at[v]), key);
      EXPECT_EQ(vertices.finest_level[v], level);
      ++v;
    }
    for (const Octant& o : tree.octants()) {
      const Lattice &lower = o.corner, upper = corner(o, 7), &at = vertices.at[v];
      for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(2 * at[axis], lower[axis] + upper[axis]);
      EXPECT_EQ(vertices.finest_level[v], o.level);
      ++v;
    }
  }
}

TEST(OctreeVertices, CornersOfAnOctantAreNumberedXFastest) {
  const Octree tree = random_tree(11);
  const OctreeVertices vertices = octree_vertices(tree);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    for (int c = 0; c < 8; ++c) {
      EXPECT_EQ(vertices.at[vertices.corners[i][c]], corner(tree[OctantId(i)], c));
    }
  }
}

TEST(OctreeVertices, FindsCornersAndNothingElse) {
  const Octree tree = random_tree(12);
  const OctreeVertices vertices = octree_vertices(tree);
  for (std::uint32_t v = 0; v < vertices.corner_count(); ++v) EXPECT_EQ(vertices.find(vertices.at[v]), v);
  for (std::size_t v = vertices.corner_count(); v < vertices.size(); ++v)
    EXPECT_EQ(vertices.find(vertices.at[v]), kNoVertex);
  EXPECT_EQ(vertices.find({1, 1, 1}), kNoVertex);
  EXPECT_EQ(vertices.find({kLatticeExtent, kLatticeExtent, kLatticeExtent - 1}), kNoVertex);
}

TEST(OctreeVertices, RanksAreDistinct) {
  const OctreeVertices vertices = octree_vertices(random_tree(13));
  std::set<std::uint64_t> ranks;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) ranks.insert(vertices.rank(v));
  EXPECT_EQ(ranks.size(), vertices.size());
}

TEST(OctantLattice, HoldsExactlyTheVerticesOnTheOctant) {
  for (unsigned seed = 20; seed < 24; ++seed) {
    const Octree tree = random_tree(seed, 30, 6);
    const OctreeVertices vertices = octree_vertices(tree);
    for (std::size_t i = 0; i < tree.size(); ++i) {
      const Octant& o = tree[OctantId(i)];
      const OctantLattice lattice = octant_lattice(vertices, OctantId(i));
      const std::uint32_t half = o.extent() / 2;
      for (std::uint32_t place = 0; place < 27; ++place) {
        const Lattice p{o.corner[0] + place % 3 * half, o.corner[1] + place / 3 % 3 * half,
                        o.corner[2] + place / 9 * half};
        EXPECT_EQ(lattice[place], place == 13 ? vertices.centre(OctantId(i)) : vertices.find(p));
      }
    }
  }
}

}  // namespace
}  // namespace octet
