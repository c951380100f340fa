// SPDX-License-Identifier: BSD-3-Clause
#include "octree/root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"

namespace octet {
namespace {

const Box3 kOddBox{Vec3(0.1, -3.3, 17.7), Vec3(1.1, 6.7, 18.9)};

TEST(Root, TheSizeIsALevel) {
  for (const double h : {0.1, 0.25, 1.0 / 3.0, 0.07, 2.0}) {
    const PlacedRoot placed = place_root(kOddBox, h);
    EXPECT_LE(placed.root.length(placed.level), h);
    EXPECT_NEAR(placed.root.length(placed.level), h, 1e-8 * h);
  }
  const PlacedRoot dyadic = place_root({Vec3::Zero(), Vec3::Ones()}, 0.125);
  EXPECT_EQ(dyadic.root.length(dyadic.level), 0.125);
}

TEST(Root, AtLeastTwoAndAHalfSizesOfOutsideSurroundThePart) {
  for (double h = 0.05; h < 20.0; h *= 1.07) {
    const PlacedRoot placed = place_root(kOddBox, h);
    const Vec3 end = placed.root.origin + Vec3::Constant(placed.root.size);
    EXPECT_GE((kOddBox.lo - placed.root.origin).minCoeff(), 2.5 * h);
    EXPECT_GE((end - kOddBox.hi).minCoeff(), 2.5 * h);
  }
}

TEST(Root, PlanesOfTheBoxMeetNoOctantPlaneForNineLevelsBelowTheSize) {
  const Box3 box{Vec3::Zero(), Vec3(1.0, 2.0, 3.0)};
  const PlacedRoot placed = place_root(box, 0.25);
  for (int level = placed.level; level < placed.level + 9; ++level) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double plane : {box.lo[axis], box.hi[axis]}) {
        const double x = (plane - placed.root.origin[axis]) / placed.root.length(level);
        EXPECT_GT(std::abs(x - std::round(x)), 0.06);
      }
    }
  }
}

TEST(Root, CornersOfAnOctantAreExact) {
  // Differences of exact multiples are exact: all edges of all octants have one and the same length.
  std::mt19937 random(3);
  for (const double h : {0.1, 0.037}) {
    const Root root = place_root(kOddBox, h).root;
    for (int i = 0; i < 1000; ++i) {
      const int level = static_cast<int>(random() % (kLatticeLevels + 1));
      const Box3 box =
          root.box(octant_of(random() & ((MortonKey{1} << (3 * std::min(level, 10))) - 1), level));
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(box.hi[axis] - box.lo[axis], root.length(level));
        EXPECT_EQ(box.centre()[axis] - box.lo[axis], root.length(level) / 2);
      }
    }
  }
}

TEST(Root, ALatticePointLiesInItsOwnCell) {
  std::mt19937 random(4);
  const Root root = place_root(kOddBox, 0.1).root;
  for (int i = 0; i < 1000; ++i) {
    Lattice p{};
    for (auto& x : p) x = static_cast<std::uint32_t>(random()) % kLatticeExtent;
    EXPECT_EQ(root.cell_of(root.position(p)), p);
  }
  EXPECT_EQ(root.cell_of(root.origin - Vec3::Ones()), (Lattice{0, 0, 0}));
  EXPECT_EQ(root.cell_of(Vec3::Constant(1e9)),
            (Lattice{kLatticeExtent - 1, kLatticeExtent - 1, kLatticeExtent - 1}));
}

TEST(Root, RefusesSizesThatAreNoSizes) {
  EXPECT_THROW((void)place_root(kOddBox, 0.0), InputError);
  EXPECT_THROW((void)place_root(kOddBox, -1.0), InputError);
  EXPECT_THROW((void)place_root(kOddBox, std::nan("")), InputError);
  EXPECT_THROW((void)place_root(kOddBox, 1e-6), LimitError);
  EXPECT_THROW((void)place_root(Box3{}, 1.0), InputError);
}

}  // namespace
}  // namespace octet
