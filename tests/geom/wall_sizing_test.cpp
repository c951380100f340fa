// SPDX-License-Identifier: BSD-3-Clause
// Thickness by rays.
#include "geom/wall_sizing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "geom/analytic.h"
#include "geom/turned_model.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

WallOptions walls(double size, double elements) {
  WallOptions options;
  options.size = size;
  options.min_size = 1e-3 * size;
  options.wall_elements = elements;
  options.gap_elements = 1.0;
  return options;
}

TEST(WallSizing, ThickPartsWishNothing) {
  EXPECT_TRUE(wall_sizes(analytic_box(Vec3(1, 1, 1)), walls(0.3, 2.0)).empty());
}

TEST(WallSizing, APlateWishesItsThicknessOnBothSides) {
  const auto samples = wall_sizes(analytic_box(Vec3(3, 3, 0.25)), walls(1.0, 1.0));
  ASSERT_FALSE(samples.empty());
  bool low = false, high = false;
  for (const SizeSample& s : samples) {
    EXPECT_NEAR(s.size, 0.25, 1e-9);
    EXPECT_EQ(s.why, SizeReason::kWall);
    low |= s.place.z() == 0.0;
    high |= s.place.z() == 0.25;
  }
  EXPECT_TRUE(low && high);
}

TEST(WallSizing, APlateWishesTheSameHoweverItLies) {
  const Model plate = analytic_box(Vec3(3, 3, 0.25));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  const auto straight = wall_sizes(plate, walls(1.0, 1.0));
  const auto oblique = wall_sizes(turned_model(plate, turn), walls(1.0, 1.0));
  ASSERT_EQ(oblique.size(), straight.size());
  for (std::size_t n = 0; n < straight.size(); ++n) {
    EXPECT_NEAR(oblique[n].size, straight[n].size, 1e-9);
    EXPECT_LT((oblique[n].place - turn * straight[n].place).norm(), 1e-9);
  }
}

TEST(WallSizing, SamplesAreDenseOverTheWall) {
  const auto samples = wall_sizes(analytic_box(Vec3(3, 3, 0.25)), walls(1.0, 1.0));
  test::Dice dice(7);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = dice.vec(Vec3::Zero(), Vec3(3, 3, 0));
    EXPECT_TRUE(std::any_of(samples.begin(), samples.end(),
                            [&](const SizeSample& s) { return (s.place - p).norm() <= s.size; }));
  }
}

TEST(WallSizing, SeveralElementsAcrossAreSampledThroughTheThickness) {
  const auto samples = wall_sizes(analytic_hollow_ball(1.0, 0.8, {{}, 1e-3}), walls(1.0, 3.0));
  ASSERT_FALSE(samples.empty());
  double deepest = 1.0;
  for (const SizeSample& s : samples) {
    EXPECT_NEAR(s.size, 0.2 / 3.2, 0.01);
    EXPECT_TRUE(s.at_most);
    if (s.place.norm() > 0.9) deepest = std::min(deepest, s.place.norm());
  }
  EXPECT_LT(deepest, 0.95);
}

TEST(WallSizing, TheSearchEndsWhenCancelled) {
  WallOptions options = walls(1.0, 1.0);
  options.cancelled = [] { return true; };
  EXPECT_THROW((void)wall_sizes(analytic_box(Vec3(3, 3, 0.25)), options), Cancelled);
}

TEST(WallSizing, WhatIsKnownIsLookedForOnce) {
  const Model plate = analytic_box(Vec3(3, 3, 0.25));
  int asked = 0;
  WallMemo memo;
  const auto look = [&](WallOptions options) {
    options.cancelled = [&asked] { return ++asked < 0; };
    std::vector<std::pair<Vec3, double>> list;
    for (const SizeSample& s : memo.sizes(plate, options).samples) list.emplace_back(s.place, s.size);
    const int before = asked;
    std::vector<std::pair<Vec3, double>> anew;
    for (const SizeSample& s : wall_sizes(plate, options)) anew.emplace_back(s.place, s.size);
    asked = before;
    EXPECT_EQ(list, anew);
  };
  look(walls(1.0, 1.0));
  const int once = asked;
  EXPECT_GT(once, 0);
  look(walls(1.0, 1.0));
  EXPECT_EQ(asked, once);
  look(walls(1.0, 2.0));  // another question
  EXPECT_GT(asked, once);
}

TEST(WallSizing, AKnifeIsNoWall) {
  for (const SizeSample& s : wall_sizes(analytic_wedge(0.1, 2.0, 2.0), walls(0.5, 1.0)))
    EXPECT_GT(s.size, 0.1);
}

TEST(WallSizing, TheBudgetRaisesTheSmallestSize) {
  WallOptions options = walls(1.0, 1.0);
  const Model sheet = analytic_box(Vec3(3, 3, 0.01));
  options.budget = 20'000.0;
  const auto samples = wall_sizes(sheet, options);
  ASSERT_FALSE(samples.empty());
  for (const SizeSample& s : samples) EXPECT_GT(s.size, 0.05);
}

TEST(WallSizing, SmallestSizesBelowTheWallAreTriedOnce) {
  constexpr double kThickness = 0.01;
  WallOptions options = walls(1.0, 1.0);
  options.budget = 20'000.0;
  int searches = 0;
  options.cancelled = [&searches] { return ++searches < 0; };
  const auto samples = wall_sizes(analytic_box(Vec3(3, 3, kThickness)), options);
  ASSERT_FALSE(samples.empty());
  int above = 0;  // smallest sizes tried, from the one that fits down to the thickness
  for (double size = samples.front().size; size > kThickness; size /= 2.0) ++above;
  EXPECT_GT(above, 1);
  EXPECT_EQ(searches, 1 + above);
}

}  // namespace
}  // namespace octet
