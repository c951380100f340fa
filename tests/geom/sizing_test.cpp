// SPDX-License-Identifier: BSD-3-Clause
// Wishes for smaller elements.
#include "geom/sizing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geom/size_wishes.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

double smallest(const std::vector<SizeSample>& samples) {
  double size = 1e9;
  for (const SizeSample& s : samples) size = std::min(size, s.size);
  return size;
}

SizingOptions options(double size) {
  SizingOptions o;
  o.size = size;
  o.min_size = 1e-3;
  return o;
}

TEST(Sizing, CoarseCubeWithSmallSizeWishesNothing) {
  EXPECT_TRUE(feature_sizes(analytic_box(Vec3(1, 1, 1)), options(0.2)).empty());
}

TEST(Sizing, CurvatureAsksForItsAnglePerElement) {
  SizingOptions o = options(5.0);
  o.edge_share = 0.0;
  o.edge_gap_elements = 0.0;
  o.curvature_angle = 0.5;
  EXPECT_NEAR(smallest(feature_sizes(analytic_ball(2.0), o)), 1.0, 1e-9);
  EXPECT_NEAR(smallest(feature_sizes(analytic_torus(3.0, 0.4), o)), 0.2, 1e-9);
  EXPECT_NEAR(smallest(feature_sizes(analytic_cylinder(1.0, 9.0), o)), 0.5, 0.01);
  o.curvature_angle = 0.0;
  EXPECT_TRUE(feature_sizes(analytic_ball(2.0), o).empty());
}

TEST(Sizing, AWishFarTooSmallIsSampledAsOftenAsAnyMayBe) {
  Wishes wishes(10.0, 0.0);
  const Model box = analytic_box(Vec3(1, 1, 1));
  wish_on_edge(box, 1, box.edge(1).t0, box.edge(1).t1, 1e-12, {}, wishes);  // a trillion: no whole number
  EXPECT_EQ(wishes.take().size(), 100'001u);
}

TEST(Sizing, TheSearchEndsWhenCancelled) {
  SizingOptions o = options(0.5);
  o.cancelled = [] { return true; };
  EXPECT_THROW((void)feature_sizes(analytic_ball(2.0), o), Cancelled);
}

TEST(Sizing, ALongThinFacetHasAsManySamplesAsItsAreaAsksFor) {
  Wishes wishes(10.0, 1e-3);
  const double length = 1000.0, width = 1.0, size = 1.0;
  wish_on_triangle({Vec3(0, 0, 0), Vec3(length, 0, 0), Vec3(0.4 * length, width, 0)}, size, {}, wishes);
  const auto samples = wishes.take();
  EXPECT_LT(samples.size(), 2.0 * length * width / (size * size));
  test::Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const double s = dice(0, 1), t = dice(0, 1 - s);
    const Vec3 p(s * length + 0.4 * t * length, t * width, 0);
    double nearest = 1e9;
    for (const SizeSample& sample : samples) nearest = std::min(nearest, (sample.place - p).norm());
    EXPECT_LT(nearest, size);
  }
}

TEST(Sizing, SamplesCoverTheCurvedFaceAtTheirOwnSpacing) {
  SizingOptions o = options(1.0);
  o.curvature_angle = 0.3;
  const Model ball = analytic_ball(1.0, {{}, 0.1});
  const auto samples = feature_sizes(ball, o);
  test::Dice dice(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = dice.direction();
    double best = 1e9;
    for (const SizeSample& s : samples) best = std::min(best, (s.place - p).norm() / s.size);
    EXPECT_LT(best, 1.0);
  }
}

TEST(Sizing, ShortEdgesAskForTheirLength) {
  SizingOptions o = options(1.0);
  o.edge_gap_elements = 0.0;
  const auto samples = feature_sizes(analytic_box(Vec3(3, 3, 0.25)), o);
  ASSERT_FALSE(samples.empty());
  for (const SizeSample& s : samples) {
    EXPECT_NEAR(s.size, 0.25, 1e-12);
    EXPECT_LT(std::min(std::abs(s.place.x()), std::abs(s.place.x() - 3)), 1e-12);
  }
}

TEST(Sizing, CloseEdgesAskForTheirGap) {
  SizingOptions o = options(1.0);
  o.edge_share = 0.0;
  const auto samples = feature_sizes(analytic_box(Vec3(3, 3, 0.25)), o);
  ASSERT_FALSE(samples.empty());
  EXPECT_NEAR(smallest(samples), 0.25, 1e-9);
  // Everywhere along the long edges, which face each other across the thickness.
  for (double x = 0.05; x < 3.0; x += 0.1) {
    const bool covered = std::any_of(samples.begin(), samples.end(), [&](const SizeSample& s) {
      return (s.place - Vec3(x, 0, 0)).norm() <= s.size;
    });
    EXPECT_TRUE(covered) << x;
  }
}

TEST(Sizing, AStepThatNoSizeResolvesAsksForNothing) {
  SizingOptions o = options(10.0);
  o.min_size = 1.0;
  o.curvature_angle = 0.0;
  // Circles that run a step apart are nearer to each other than to their chords.
  const std::vector<std::function<Model(double)>> parts{
      [](double height) { return analytic_box(Vec3(30, 30, height)); },
      [](double height) { return analytic_cylinder(15.0, height); }};
  for (const auto& of_height : parts) {
    const auto samples = feature_sizes(of_height(1.1 * o.min_size / 32), o);
    ASSERT_FALSE(samples.empty());
    EXPECT_EQ(smallest(samples), o.min_size);
    EXPECT_TRUE(feature_sizes(of_height(0.9 * o.min_size / 32), o).empty());
    SizingOptions finer = o;
    finer.min_size = 1e-3;
    EXPECT_LT(smallest(feature_sizes(of_height(0.9 * o.min_size / 32), finer)), 0.03);
  }
}

TEST(Sizing, NoWishIsBelowTheSmallestSizeOrAboveTheSizeAskedFor) {
  SizingOptions o = options(0.5);
  o.min_size = 0.3;
  for (const auto& s : test::all_samples())
    for (const SizeSample& w : feature_sizes(s.model, o)) {
      EXPECT_GE(w.size, 0.3);
      EXPECT_LT(w.size, 0.5);
    }
}

TEST(Sizing, WhatIsKnownOfFeaturesAnswersAnotherQuestionAsAnewSearchDoes) {
  const Model cylinder = analytic_cylinder(1.0, 0.25);
  FeatureMemo memo;
  const auto listed = [](const std::vector<SizeSample>& samples) {
    std::vector<std::pair<Vec3, double>> list;
    for (const SizeSample& s : samples) list.emplace_back(s.place, s.size);
    return list;
  };
  SizingOptions asked = options(1.0);
  const auto look = [&] {
    const auto anew = listed(feature_sizes(cylinder, asked));
    EXPECT_EQ(listed(memo.sizes(cylinder, asked)), anew);
    return anew;
  };
  asked.curvature_angle = 0.785;
  const auto first = look();
  asked.curvature_angle = 0.2;
  const auto rounder = look();
  EXPECT_GT(rounder.size(), first.size());
  asked.size = 0.3;
  EXPECT_NE(look(), rounder);
  asked.edge_gap_elements = 4.0;
  asked.curvature_angle = 0.0;
  EXPECT_FALSE(look().empty());
  asked.min_size = 0.1;
  look();
}

TEST(Sizing, DefaultSizeFollowsThicknessBetweenItsBounds) {
  const Model cube = analytic_box(Vec3(1, 1, 1)), sheet = analytic_box(Vec3(1, 1, 1e-3));
  const Model plate = analytic_box(Vec3(1, 1, 0.04));
  EXPECT_NEAR(default_size(cube), cube.diagonal() / 17, 1e-12);
  EXPECT_NEAR(default_size(sheet), sheet.diagonal() / 85, 1e-12);
  EXPECT_NEAR(default_size(plate), 2.3 * 0.04 / 2.16, 1e-12);
}

TEST(Sizing, ARegionsDefaultSizeFollowsItsOwnExtent) {
  const Model model = analytic_two_boxes(Vec3(1, 2, 3));
  const std::vector<double> sizes = default_region_sizes(model);
  ASSERT_EQ(sizes.size(), 3u);
  for (int r = 1; r <= 2; ++r) EXPECT_NEAR(sizes[r], Vec3(1, 2, 3).norm() / 12, 1e-12);
  EXPECT_LT(sizes[1], model.diagonal() / 12);
}

}  // namespace
}  // namespace octet
