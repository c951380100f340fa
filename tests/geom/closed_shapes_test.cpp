// SPDX-License-Identifier: BSD-3-Clause
// What surfaces and curves are made of comes back out of them.
#include "geom/closed_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/conics.h"
#include "geom/quadrics.h"
#include "geom/torus.h"
#include "sample_models.h"

namespace octet {
namespace {

Axes3 tilted_axes(double hand = 1.0) {
  const Frame frame = test::tilted_frame();
  return {frame.origin, frame.axes.col(0), hand * frame.axes.col(1), frame.axes.col(2)};
}

/// As it is, or the other way round.
double off_line(const Vec3& direction, const Vec3& other) { return direction.cross(other).norm(); }

TEST(ClosedShapes, OfACylinderAreRadiusAndAxis) {
  for (const double hand : {1.0, -1.0}) {
    const Axes3 axes = tilted_axes(hand);
    const auto shape = round_shape(*make_cylinder(axes, 2.5, 1.0));
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->radius, 2.5, 1e-13);
    EXPECT_NEAR(shape->axis.norm(), 1.0, 1e-14);
    EXPECT_GT(shape->axis.maxCoeff(), -shape->axis.minCoeff());
    EXPECT_LT(off_line(shape->axis, axes.z), 1e-14);
    EXPECT_LT(off_line(axes.z, shape->origin - axes.origin), 1e-13);
  }
}

TEST(ClosedShapes, OfAConeAreApexAngleAndAxis) {
  const Axes3 axes = tilted_axes();
  for (const double angle : {0.3, -0.3, 1.2})
    for (const double radius : {0.0, 4.0}) {
      const auto shape = round_shape(*make_cone(axes, angle, radius));
      ASSERT_TRUE(shape);
      EXPECT_NEAR(shape->half_angle, std::abs(angle), 1e-14);
      EXPECT_LT(off_line(shape->axis, axes.z), 1e-14);
      EXPECT_LT((shape->origin - (axes.origin - radius / std::tan(angle) * axes.z)).norm(), 1e-12);
    }
}

TEST(ClosedShapes, OfASphereAreItsMiddleAndRadius) {
  const auto shape = round_shape(*make_sphere(tilted_axes(), 3.0));
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->radius, 3.0, 1e-13);
  EXPECT_TRUE(shape->axis.isZero());
  EXPECT_LT((shape->origin - tilted_axes().origin).norm(), 1e-13);
}

TEST(ClosedShapes, OfATorusAreBothRadiiAndTheAxis) {
  for (const double minor : {1.0, 7.0}) {
    const auto shape = round_shape(*make_torus(tilted_axes(), 5.0, minor));
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->radius, 5.0, 1e-13);
    EXPECT_NEAR(shape->minor_radius, minor, 1e-13);
    EXPECT_LT(off_line(shape->axis, tilted_axes().z), 1e-14);
    EXPECT_LT((shape->origin - tilted_axes().origin).norm(), 1e-13);
  }
}

TEST(ClosedShapes, OfArcsAreThoseOfTheWholeCurve) {
  const Axes3 axes = tilted_axes();
  const auto circle = conic_shape(*make_circle(axes, 2.0, 1.0, 1.5));
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->centre - axes.origin).norm(), 1e-13);
  EXPECT_LT(off_line(circle->axis, axes.z), 1e-14);
  EXPECT_NEAR(circle->radii[0], 2.0, 1e-13);
  EXPECT_NEAR(circle->radii[1], 2.0, 1e-13);
  const auto ellipse = conic_shape(*make_ellipse(axes, 2.0, 0.5, 1.0, 1.5));
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR(ellipse->radii[0], 2.0, 1e-13);
  EXPECT_NEAR(ellipse->radii[1], 0.5, 1e-13);
}

TEST(ClosedShapes, PlanesAndLinesHaveNone) {
  EXPECT_FALSE(round_shape(*make_plane(tilted_axes())));
  EXPECT_FALSE(conic_shape(*make_line(Vec3::Zero(), Vec3::UnitX(), 0.0, 1.0)));
}

}  // namespace
}  // namespace octet
