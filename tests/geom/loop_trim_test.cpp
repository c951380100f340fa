// SPDX-License-Identifier: BSD-3-Clause
// In and out of loops whose answer is known.
#include "geom/loop_trim.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace octet {
namespace {

TrimCurve line(const Vec2& a, const Vec2& b, int from, int to, int edge) {
  TrimCurve curve;
  curve.at = [a, b](double t) { return Vec2(a + t * (b - a)); };
  curve.breaks = {0.0, 1.0};
  curve.straight = true;
  curve.vertex = {from, to};
  curve.edge = edge;
  return curve;
}

TrimCurve ellipse(const Vec2& centre, const Vec2& radius, int vertex, int edge) {
  TrimCurve curve;
  curve.at = [=](double t) { return Vec2(centre + radius.cwiseProduct(Vec2(std::cos(t), std::sin(t)))); };
  curve.breaks = {0.3, 0.3 + kTurn};
  curve.vertex = {vertex, vertex};
  curve.edge = edge;
  return curve;
}

/// A loop around the whole period of u, at height v0 + wave sin u, from u0 on.
TrimCurve around(double u0, double v0, double wave, int vertex, int edge) {
  TrimCurve curve;
  curve.at = [=](double t) { return Vec2(t, v0 + wave * std::sin(t)); };
  curve.breaks = {u0, u0 + kTurn};
  curve.vertex = {vertex, vertex};
  curve.edge = edge;
  return curve;
}

constexpr double kBand = 1e-9;
const LoopTrimOptions kPlain{Vec2::Constant(kBand), Vec2::Zero()};
const LoopTrimOptions kAround{Vec2::Constant(kBand), Vec2(kTurn, 0.0)};

struct Random {
  double operator()(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  std::mt19937_64 generator{7};
};

TEST(LoopTrim, AnAnnulusIsInBetweenItsEllipses) {
  const Vec2 outer(3.0, 200.0), inner(1.0, 150.0), hole(0.4, -20.0);
  const auto trim =
      make_loop_trim({ellipse({1.0, 5.0}, outer, 1, 1), ellipse(Vec2(1.0, 5.0) + hole, inner, 2, 2)}, kPlain);
  ASSERT_TRUE(trim);
  Random random;
  int in = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec2 p(random(-3, 5), random(-250, 250));
    const Vec2 d = p - Vec2(1.0, 5.0);
    const bool expected = d.cwiseQuotient(outer).norm() < 1.0 && (d - hole).cwiseQuotient(inner).norm() > 1.0;
    ASSERT_EQ(trim->side(p), expected ? TrimSide::kIn : TrimSide::kOut) << p.transpose();
    in += expected;
  }
  EXPECT_GT(in, 30000);
}

TEST(LoopTrim, TellsTheSideOfACurveDownToTheBandAndSaysOnWithinIt) {
  const auto trim = make_loop_trim({ellipse({0.0, 0.0}, {1.0, 1.0}, 1, 1)}, kPlain);
  ASSERT_TRUE(trim);
  for (int i = 0; i < 1000; ++i) {
    const double a = 0.006 * i;
    const Vec2 e(std::cos(a), std::sin(a));
    for (const double depth : {1e-2, 1e-4, 1e-6, 1e-8}) {
      EXPECT_EQ(trim->side((1.0 - depth) * e), TrimSide::kIn) << a << " at " << depth;
      EXPECT_EQ(trim->side((1.0 + depth) * e), TrimSide::kOut) << a << " at " << depth;
    }
    EXPECT_EQ(trim->side(e), TrimSide::kOn) << a;
  }
}

TEST(LoopTrim, ASeamBoundsThePeriodAndPointsAreMovedIntoIt) {
  // A cylinder from v = 0 to 1, its seam at u = 1 and 1 + 2 pi.
  const Vec2 a(1.0, 0.0), b(1.0 + kTurn, 0.0), c(1.0 + kTurn, 1.0), d(1.0, 1.0);
  const auto trim = make_loop_trim(
      {line(a, b, 1, 1, 1), line(b, c, 1, 2, 2), line(d, c, 2, 2, 3), line(a, d, 1, 2, 2)}, kAround);
  ASSERT_TRUE(trim);
  for (const double turns : {-2.0, -1.0, 0.0, 1.0})
    for (int i = 0; i < 60; ++i) {
      const double u = 0.1 * i + 0.013 + turns * kTurn;
      EXPECT_EQ(trim->side({u, 0.5}), TrimSide::kIn) << u;
      EXPECT_EQ(trim->side({u, 1.001}), TrimSide::kOut) << u;
      EXPECT_EQ(trim->side({u, -0.001}), TrimSide::kOut) << u;
      EXPECT_EQ(trim->side({u, 1.0}), TrimSide::kOn) << u;
    }
  EXPECT_EQ(trim->side({1.0, 0.5}), TrimSide::kOn);
}

TEST(LoopTrim, LoopsAroundAPeriodNeedNoSeamAndMayStartAnywhere) {
  const auto trim = make_loop_trim(
      {around(0.0, 0.0, 0.2, 1, 1), around(2.5, 2.0, -0.3, 2, 2), ellipse({6.2, 1.0}, {0.3, 0.2}, 3, 3)},
      kAround);
  ASSERT_TRUE(trim);
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 p(random(-7.0, 14.0), random(-1.0, 3.0));
    bool expected = p.y() > 0.2 * std::sin(p.x()) && p.y() < 2.0 - 0.3 * std::sin(p.x());
    for (int k = -3; k <= 3; ++k)
      expected &= (p - Vec2(6.2 + k * kTurn, 1.0)).cwiseQuotient(Vec2(0.3, 0.2)).norm() > 1.0;
    ASSERT_EQ(trim->side(p), expected ? TrimSide::kIn : TrimSide::kOut) << p.transpose();
  }
}

TEST(LoopTrim, ClosesGapsBetweenCurvesAtAVertexWithStraightPieces) {
  // The corners of this square do not meet: at vertex 2 and at a pole, 3, that has no curve of its own.
  const auto trim = make_loop_trim(
      {line({0, 0}, {0.99, 0}, 1, 2, 1), line({1, 0.01}, {1, 1}, 2, 3, 2), line({0, 1}, {0, 0}, 3, 1, 4)},
      kPlain);
  ASSERT_TRUE(trim);
  EXPECT_EQ(trim->side({0.5, 0.999}), TrimSide::kIn);
  EXPECT_EQ(trim->side({0.5, 1.001}), TrimSide::kOut);
  EXPECT_EQ(trim->side({0.9999, 0.0001}), TrimSide::kOut);
  EXPECT_EQ(trim->side({0.994, 0.006}), TrimSide::kIn);
}

TEST(LoopTrim, IsNotMadeOfAnOpenLoop) {
  EXPECT_FALSE(make_loop_trim({line({0, 0}, {1, 0}, 1, 2, 1), line({1, 0}, {1, 1}, 2, 3, 2)}, kPlain));
}

TEST(LoopTrim, ASlitHasTheFaceOnBothSides) {
  const auto trim =
      make_loop_trim({ellipse({0.0, 0.0}, {1.0, 1.0}, 1, 1), line({-0.5, 0.1}, {0.5, 0.1}, 2, 3, 2),
                      line({-0.5, 0.1}, {0.5, 0.1}, 2, 3, 2)},
                     kPlain);
  ASSERT_TRUE(trim);
  EXPECT_EQ(trim->side({0.0, 0.101}), TrimSide::kIn);
  EXPECT_EQ(trim->side({0.0, 0.099}), TrimSide::kIn);
  EXPECT_EQ(trim->side({-0.7, 0.1}), TrimSide::kIn);
}

}  // namespace
}  // namespace octet
