// SPDX-License-Identifier: BSD-3-Clause
// Lines, circles and ellipses, and lengths along them.
#include "geom/conics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/arc_length.h"
#include "geom/curve_samples.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

struct Case {
  std::shared_ptr<const Curve> curve;
  double t0, t1;
};

std::vector<Case> all_cases() {
  const Frame f = test::tilted_frame();
  Axes3 axes{f.origin, f.axes.col(0), f.axes.col(1), f.axes.col(2)};
  Axes3 left = axes;
  left.y = -left.y;
  return {{make_line(f.origin, f.axes.col(1) * 2.0, -1.0, 2.0), -1.0, 2.0},
          {make_circle(axes, 1.5, 0.5, 0.5 + kTwoPi), 0.5, 0.5 + kTwoPi},
          {make_circle(left, 0.7, -1.0, 1.25), -1.0, 1.25},
          {make_ellipse(axes, 2.0, 0.5, 1.0, 1.0 + kTwoPi), 1.0, 1.0 + kTwoPi},
          {make_ellipse(left, 2.0, 1.9, 3.0, 5.0), 3.0, 5.0}};
}

TEST(Conics, DerivativeIsTheLimitOfDifferences) {
  for (const Case& c : all_cases())
    for (double s = 0.05; s < 1.0; s += 0.1) {
      const double t = c.t0 + s * (c.t1 - c.t0), h = 1e-6;
      const Vec3 difference = (c.curve->point(t + h) - c.curve->point(t - h)) / (2 * h);
      EXPECT_LT((difference - c.curve->derivative(t)).norm(), 1e-8) << c.curve->kind();
    }
}

TEST(Conics, ProjectionIsNoFartherThanAnyPointOfTheArc) {
  for (const Case& c : all_cases()) {
    Dice dice(1);
    const Vec3 o = test::tilted_frame().origin;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = o + 3.0 * dice(0.01, 1.0) * dice.direction();
      const double t = c.curve->project(p, 0.5 * (c.t0 + c.t1));
      ASSERT_GE(t, c.t0);
      ASSERT_LE(t, c.t1);
      const double d = (c.curve->point(t) - p).norm();
      for (int k = 0; k <= 500; ++k)
        ASSERT_LE(d, (c.curve->point(c.t0 + (c.t1 - c.t0) * k / 500) - p).norm() + 1e-12) << c.curve->kind();
    }
  }
}

TEST(Conics, CutsAreWhereTheCoordinateChangesSign) {
  for (const Case& c : all_cases()) {
    Dice dice(2);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 100; ++i) {
        const double value = c.curve->point(dice(c.t0, c.t1))[axis] + dice(-0.3, 0.3);
        std::vector<double> cuts;
        c.curve->cut(Vec3::Unit(axis), value, cuts);
        EXPECT_TRUE(std::is_sorted(cuts.begin(), cuts.end()));
        for (const double t : cuts) ASSERT_NEAR(c.curve->point(t)[axis], value, 1e-13);
        std::size_t changes = 0;
        constexpr int kSteps = 2000;
        for (int k = 0; k < kSteps; ++k) {
          const double a = c.curve->point(c.t0 + (c.t1 - c.t0) * k / kSteps)[axis] - value;
          const double b = c.curve->point(c.t0 + (c.t1 - c.t0) * (k + 1) / kSteps)[axis] - value;
          changes += (a > 0) != (b > 0);
        }
        ASSERT_GE(cuts.size(), changes) << c.curve->kind();
        ASSERT_LE(cuts.size(), 2u);
      }
  }
}

TEST(Conics, TouchingPlaneCutsACircleOnce) {
  const auto circle = make_circle({}, 1.0, 0.0, kTwoPi);
  std::vector<double> cuts;
  circle->cut(Vec3::UnitY(), 1.0, cuts);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_NEAR(cuts[0], 0.5 * std::numbers::pi, 1e-15);
  circle->cut(Vec3::UnitZ(), 0.0, cuts);  // the circle lies in the plane: no cut of its own
  EXPECT_EQ(cuts.size(), 1u);
}

TEST(ArcLength, CircleAndLineAreExact) {
  const auto circle = make_circle({}, 2.0, 0.0, kTwoPi);
  const ArcLength length(*circle, 0.0, kTwoPi);
  EXPECT_NEAR(length.total(), 2.0 * kTwoPi, 1e-13);
  EXPECT_NEAR(length.length(*circle, 1.0, 2.5), 3.0, 1e-13);
  EXPECT_NEAR(length.length(*circle, 2.5, 1.0), -3.0, 1e-13);
  EXPECT_NEAR(length.parameter(*circle, 1.0, 3.0), 2.5, 1e-13);
  EXPECT_EQ(length.parameter(*circle, 1.0, 100.0), kTwoPi);
}

TEST(ArcLength, EllipseAgreesWithItsPerimeter) {
  const auto ellipse = make_ellipse({}, 2.0, 0.1, 0.0, kTwoPi);
  const ArcLength length(*ellipse, 0.0, kTwoPi);
  double sum = 0.0;
  constexpr int kSteps = 200000;
  for (int k = 0; k < kSteps; ++k)
    sum += ellipse->derivative(kTwoPi * (k + 0.5) / kSteps).norm() * kTwoPi / kSteps;
  EXPECT_NEAR(length.total(), sum, 1e-9);
  const double t = length.parameter(*ellipse, 0.0, 0.3 * length.total());
  EXPECT_NEAR(length.length(*ellipse, 0.0, t), 0.3 * length.total(), 1e-12);
}

/// A helix, whose projection is local: it starts at the hint.
class Helix final : public Curve {
 public:
  Vec3 point(double t) const override { return {std::cos(t), std::sin(t), 0.1 * t}; }
  Vec3 derivative(double t) const override { return {-std::sin(t), std::cos(t), 0.1}; }
  double project(const Vec3& p, double hint) const override {
    double t = hint;
    for (int i = 0; i < 30; ++i) {
      const Vec3 d = derivative(t);
      t = std::clamp(t - (point(t) - p).dot(d) / d.squaredNorm(), 0.0, 40.0);
    }
    return t;
  }
  void cut(const Vec3&, double, std::vector<double>&) const override {}
  const char* kind() const override { return "helix"; }
};

TEST(CurveSamples, NearestOfAHelixIsOnTheRightTurn) {
  const Helix helix;
  const CurveSamples samples(helix, 0.0, 40.0);
  Dice dice(3);
  for (int i = 0; i < 300; ++i) {
    const double t = dice(0.0, 40.0);
    const Vec3 p = helix.point(t) + 0.05 * dice.direction();
    const CurveFoot foot = samples.nearest(helix, p);
    EXPECT_NEAR(foot.t, t, 0.1);
    EXPECT_LE(foot.distance, (helix.point(t) - p).norm() + 1e-12);
  }
}

}  // namespace
}  // namespace octet
