// SPDX-License-Identifier: BSD-3-Clause
#include "finalize/shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/quality.h"
#include "mesh/tet_mesh.h"
#include "tests/finalize/builders.h"

namespace octet {
namespace {

TEST(Shape, IsTheSquaredSineOfTheWorstDihedralOrTheWeightedCubeOfTheMeanRatio) {
  testing::Dice dice(7);
  const auto random = [&] {
    const double x = dice.roll(), y = dice.roll(), z = dice.roll();
    return Vec3(x, y, z);
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random(), b = random(), c = random();
    Vec3 d = random();
    if (signed_volume(a, b, c, d) < 0.0) d = a + b - d;
    if (signed_volume(a, b, c, d) < 1e-4) continue;
    const DihedralRange range = dihedral_range(a, b, c, d);
    const double s = std::min(std::sin(range.smallest), std::sin(range.largest));
    const double ratio = mean_ratio(a, b, c, d);
    EXPECT_NEAR(shape(a, b, c, d), std::min(s * s, kRatioWeight * ratio * ratio * ratio), 1e-9);
  }
}

TEST(Shape, OfTheRegularTetrahedronIsEightNinths) {
  const Vec3 a(1, 1, 1), b(-1, 1, -1), c(1, -1, -1), d(-1, -1, 1);
  EXPECT_NEAR(shape(a, b, c, d), 8.0 / 9.0, 1e-14);
}

TEST(Shape, ChangesSignWithTheOrientationAndIsZeroWhenFlat) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0.2, 0.3, 1);
  EXPECT_GT(shape(a, b, c, d), 0.0);
  EXPECT_LT(shape(b, a, c, d), 0.0);
  EXPECT_EQ(shape(a, b, c, Vec3(0.5, 0.25, 0.0)), 0.0);
}

TEST(Shape, OfANeedleIsBadThoughItsAnglesAreGood) {
  const Vec3 a(0, 0, 0), b(0.1, 0, 0), c(0.05, 0.0866, 0), d(0.05, 0.0289, 3);
  const DihedralRange range = dihedral_range(a, b, c, d);
  EXPECT_GT(range.smallest, 0.9);
  EXPECT_LT(range.largest, 1.7);
  EXPECT_LT(shape(a, b, c, d), 0.05);
}

TEST(Shape, RootsOfTheMeritsHaveTheGradientsThatDifferencesTell) {
  testing::Dice dice(11);
  const auto random = [&] {
    const double x = dice.roll(), y = dice.roll(), z = dice.roll();
    return Vec3(x, y, z);
  };
  for (int i = 0; i < 50; ++i) {
    const Vec3 a = random(), b = random(), c = random(), d = random();
    if (std::abs(signed_volume(a, b, c, d)) < 1e-3) continue;
    const auto squares = merits_of_shape(a, b, c, d);
    const RootMerits roots = root_merits(a, b, c, d);
    for (std::size_t e = 0; e < 7; ++e) {
      EXPECT_NEAR(roots.value[e] * std::abs(roots.value[e]), squares[e], 1e-12);
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 offset = 1e-6 * Vec3::Unit(axis);
        const double rise =
            root_merits(a, b, c, d + offset).value[e] - root_merits(a, b, c, d - offset).value[e];
        EXPECT_NEAR(roots.gradient[e][axis], rise / 2e-6, 1e-4 * (1.0 + std::abs(rise / 2e-6)));
      }
    }
  }
}

TEST(Shape, ListsSinesInTheOrderOfTheEdges) {
  const Vec3 p[4] = {{0, 0, 0}, {1, 0.1, 0}, {0.2, 1, 0.1}, {0.3, 0.3, 0.4}};
  const auto squares = merits_of_shape(p[0], p[1], p[2], p[3]);
  for (int e = 0; e < 6; ++e) {
    const Vec3 &a = p[kTetEdge[e][0]], &b = p[kTetEdge[e][1]];
    const Vec3 &c = p[kTetEdge[5 - e][0]], &d = p[kTetEdge[5 - e][1]];
    const Vec3 n = (b - a).cross(c - a).normalized(), m = (b - a).cross(d - a).normalized();
    EXPECT_NEAR(squares[static_cast<std::size_t>(e)], n.cross(m).squaredNorm(), 1e-12);
  }
}

}  // namespace
}  // namespace octet
