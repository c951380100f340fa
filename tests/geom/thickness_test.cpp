// SPDX-License-Identifier: BSD-3-Clause
// The thinnest wall of bodies whose walls are known.
#include "geom/thickness.h"

#include <gtest/gtest.h>

#include "geom/analytic.h"

namespace octet {
namespace {

double thinnest(const Model& model) {
  const auto wall = thinnest_wall(model);
  return wall ? wall->thickness : 0.0;
}

TEST(Thickness, OfABoxIsItsSmallestSide) {
  const auto wall = thinnest_wall(analytic_box(Vec3(5, 2, 3)));
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, 2.0, 1e-12);
  EXPECT_NEAR(std::abs((wall->to - wall->from).y()), 2.0, 1e-12);
  EXPECT_EQ(wall->region, 1);
  EXPECT_NE(wall->face, wall->opposite);
}

TEST(Thickness, OfAHollowBallIsItsShell) { EXPECT_NEAR(thinnest(analytic_hollow_ball(3.0, 2.5)), 0.5, 1e-9); }

TEST(Thickness, OfARodIsItsDiameter) {
  const auto wall = thinnest_wall(analytic_cylinder(1.0, 20.0));
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, 2.0, 1e-9);
  EXPECT_EQ(wall->face, wall->opposite);
}

TEST(Thickness, OfTwoBodiesSideBySideIsNotThatOfBothTogether) {
  EXPECT_NEAR(thinnest(analytic_two_boxes(Vec3(1, 2, 3))), 1.0, 1e-12);
}

TEST(Thickness, DoesNotRunOutWhereAWedgeEnds) { EXPECT_GT(thinnest(analytic_wedge(0.2, 10.0, 4.0)), 0.5); }

}  // namespace
}  // namespace octet
