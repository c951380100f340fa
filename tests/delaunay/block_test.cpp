// SPDX-License-Identifier: BSD-3-Clause
// Blocks give exactly the tetrahedra of the whole.
#include "delaunay/block.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/delaunay/balanced_octree.h"
#include "tests/delaunay/point_sets.h"

namespace octet {
namespace {

using namespace testing;

TEST(PointIndex, GathersExactlyThePointsOfABox) {
  Engine engine(1);
  RankedPoints set = random_points(500, engine);
  for (int i = 0; i < 100; ++i) set.add({0.1 * (i % 10), 0.1 * (i / 10), 3.0}, 0);
  const PointIndex index(set.points);
  std::vector<std::uint32_t> found;
  for (int n = 0; n < 100; ++n) {
    Box3 box;
    box.add(4.0 * Vec3(real(engine), real(engine), real(engine)) - Vec3::Constant(1.0));
    box.add(4.0 * Vec3(real(engine), real(engine), real(engine)) - Vec3::Constant(1.0));
    if (n % 3 == 0) box.hi = set.points[below(engine, set.size())].cwiseMax(box.lo);
    index.gather(box, found);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < set.size(); ++i) {
      if (box.contains(set.points[i])) expected.push_back(i);
    }
    ASSERT_EQ(found, expected);
  }
}

// Tiles the bounds by blocks^3 boxes; their tetrahedra must be those of the whole, each once.
struct Tally {
  std::size_t rounds = 0, whole = 0, boxes = 0;
};
Tally expect_blocks_make_the_whole(const RankedPoints& set, int blocks, double halo) {
  const PointIndex index(set.points);
  const Vec3 lo = index.bounds().lo, size = index.bounds().size();
  Tally tally;
  TetSet pieces;
  for (int k = 0; k < blocks; ++k) {
    for (int j = 0; j < blocks; ++j) {
      for (int i = 0; i < blocks; ++i) {
        const auto corner = [&](int a, int b, int c) -> Vec3 {
          Vec3 p = lo + size.cwiseProduct(Vec3(a, b, c) / blocks);
          for (int axis = 0; axis < 3; ++axis) {
            if ((axis == 0 ? a : axis == 1 ? b : c) == blocks) p[axis] = index.bounds().hi[axis];
          }
          return p;
        };
        const BlockTets block =
            block_tets(index, set.ranks, {corner(i, j, k), corner(i + 1, j + 1, k + 1)}, halo);
        for (const auto& t : block.tets) pieces.push_back(testing::canonical(t));
        tally.rounds += static_cast<std::size_t>(block.rounds);
        tally.whole += block.gathered == set.size() ? 1 : 0;
        ++tally.boxes;
      }
    }
  }
  std::sort(pieces.begin(), pieces.end());
  EXPECT_EQ(pieces, tet_set(triangulate(set)));
  return tally;
}

TEST(Block, BlocksOfRandomPointsMakeTheWhole) {
  Engine engine(2);
  expect_blocks_make_the_whole(random_points(3000, engine), 3, 0.05);
}

TEST(Block, BlocksOfALatticeMakeTheWholeWithASmallHalo) {
  Engine engine(3);
  const RankedPoints set = lattice_points(13, 13, 13, 0.5, engine);
  const Tally tally = expect_blocks_make_the_whole(set, 3, 0.75);
  EXPECT_EQ(tally.rounds, tally.boxes);
  EXPECT_EQ(tally.whole, 0u);
}

TEST(Block, BlocksOfOctreeVerticesMakeTheWholeWithoutGatheringIt) {
  Engine engine(4);
  RankedPoints set = BalancedOctree(3, 5, 0.3, engine).vertices();
  const Tally tally = expect_blocks_make_the_whole(set, 4, 0.03);
  EXPECT_GT(tally.rounds, tally.boxes);
  EXPECT_LT(tally.whole, 4u);
}

TEST(Block, BlocksOfOctreeVerticesAndFreePointsMakeTheWhole) {
  Engine engine(5);
  RankedPoints set = BalancedOctree(3, 5, 0.3, engine).vertices();
  for (std::uint64_t n = 0; n < 800; ++n) {
    const double x = 0.25 + 0.5 * real(engine), y = 0.25 + 0.5 * real(engine);
    set.add({x, y, 0.3 * x + 0.4 * y + 0.1}, free_point_rank(n));  // an oblique sheet: noise-flat tetrahedra
  }
  const Tally tally = expect_blocks_make_the_whole(set, 3, 0.1);
  EXPECT_LT(tally.whole, 8u);
}

TEST(Block, ABlockWithoutPointsIsEmpty) {
  Engine engine(6);
  const RankedPoints set = random_points(100, engine);
  const PointIndex index(set.points);
  EXPECT_TRUE(block_tets(index, set.ranks, {Vec3(2, 2, 2), Vec3(3, 3, 3)}, 0.1).tets.empty());
}

TEST(Block, RefusesPointsOfOnePlane) {
  RankedPoints set;
  for (int i = 0; i < 20; ++i) set.add({0.1 * i, 0.1 * i * i, 1.0}, static_cast<std::uint64_t>(i));
  const PointIndex index(set.points);
  EXPECT_THROW((void)block_tets(index, set.ranks, {Vec3(0, 0, 0), Vec3(1, 1, 2)}, 0.1), InputError);
}

}  // namespace
}  // namespace octet
