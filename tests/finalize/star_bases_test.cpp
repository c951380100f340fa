// SPDX-License-Identifier: BSD-3-Clause
// A star measured four tetrahedra at a time has the shapes and distortions of its tetrahedra, one by one.
#include "finalize/star_bases.h"

#include <gtest/gtest.h>

#include "finalize/shape.h"
#include "tests/finalize/builders.h"

namespace octet {
namespace {

/// `count` bases in the plane z = 0, seen counter-clockwise from above.
struct Star {
  explicit Star(std::size_t count) {
    testing::Dice dice(5);
    const auto roll = [&] {
      const double x = dice.roll(), y = dice.roll();
      return Vec3(x, y, 0.1 * dice.roll());
    };
    bases.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 x = roll(), y = roll();
      const Vec3 z = roll();
      if ((y - x).cross(z - x).z() < 0.0) std::swap(x, y);
      corners.push_back({x, y, z});
      bases.set(i, x, y, z);
    }
    bases.close();
  }
  std::vector<std::array<Vec3, 3>> corners;
  StarBases bases;
};

class StarOf : public ::testing::TestWithParam<std::size_t> {};

TEST_P(StarOf, HasTheShapesAndDistortionsOfItsTetrahedra) {
  Star star(GetParam());
  const Vec3 place(0.3, 0.4, 0.8);
  const StarMeasure measure = star.bases.measure(place);
  Distortion sum, expected;
  ASSERT_TRUE(star.bases.differentiate(place, sum));
  double worst = 1.0;
  for (std::size_t i = 0; i < star.corners.size(); ++i) {
    const auto& [x, y, z] = star.corners[i];
    const double value = shape(x, y, z, place);
    EXPECT_NEAR(star.bases.shapes()[i] / value, 1.0, 1e-12);
    EXPECT_EQ(star.bases[i], star.corners[i]);
    worst = std::min(worst, value);
    ASSERT_TRUE(add_distortion(x, y, z, place, expected));
  }
  EXPECT_NEAR(measure.worst, worst, 1e-14);
  EXPECT_NEAR(measure.distortion / expected.value, 1.0, 1e-12);
  EXPECT_NEAR(sum.value / expected.value, 1.0, 1e-12);
  EXPECT_LT((sum.gradient - expected.gradient).norm(), 1e-10 * expected.gradient.norm());
  EXPECT_LT((sum.hessian - expected.hessian).norm(), 1e-10 * expected.hessian.norm());
}

INSTANTIATE_TEST_SUITE_P(Sizes, StarOf, ::testing::Values(1, 4, 5, 23));

TEST(StarBases, AreNotPositiveFromBelowNorFromWithinTheirPlane) {
  StarBases bases;
  bases.resize(1);
  bases.set(0, Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  bases.close();
  Distortion sum;
  for (const double height : {0.0, -0.5}) {
    EXPECT_LE(bases.measure(Vec3(0.2, 0.2, height)).worst, 0.0);
    EXPECT_FALSE(bases.differentiate(Vec3(0.2, 0.2, height), sum));
  }
}

TEST(StarBases, WithoutAreaHaveNoShape) {
  StarBases bases;
  bases.resize(1);
  bases.set(0, Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1));
  bases.close();
  EXPECT_EQ(bases.measure(Vec3(1, 1, 1)).worst, 0.0);
  EXPECT_EQ(bases.measure(Vec3(2, 1, 1)).worst, 0.0);
}

TEST(StarBases, ForgetWhatTheyWereWhenResized) {
  Star star(7);
  star.bases.resize(1);
  const std::array<Vec3, 3> base{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  star.bases.set(0, base[0], base[1], base[2]);
  star.bases.close();
  ASSERT_EQ(star.bases.size(), 1u);
  const Vec3 place(0.3, 0.3, 0.7);
  EXPECT_NEAR(star.bases.measure(place).worst, shape(base[0], base[1], base[2], place), 1e-14);
}

}  // namespace
}  // namespace octet
