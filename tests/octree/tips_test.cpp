// SPDX-License-Identifier: BSD-3-Clause
// Sharp tips: which vertices have one, and that points keep to its ring.
#include "octree/tips.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/analytic.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

constexpr double kSize = 0.25;

Octree tree_of(const Model& model) {
  OctreeRequest request;
  request.size = kSize;
  return build_octree(model, request, {});
}

Frame oblique() {
  Frame frame;
  frame.origin = Vec3(0.3, -0.2, 0.7);
  frame.axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  return frame;
}

/// Below 0: within.
double distance_from_ball(const Tip& tip, const Vec3& p) {
  const double radius = 0.5 * tip.reach;
  return (p - tip.place - radius * tip.along).norm() - radius;
}

TEST(Tips, OnlySharpConesHaveOne) {
  for (const double height : {5.0, 12.0, 50.0}) {
    const Model cone = analytic_cone(1.0, height, {oblique(), 1e-3});
    EXPECT_EQ(Tips(cone, tree_of(cone)).all().size(), 1u) << height;
  }
  const Model blunt = analytic_cone(1.0, 2.0), ball = analytic_ball(1.0), rod = analytic_cylinder(1.0, 2.0);
  for (const Model* model : {&blunt, &ball, &rod}) EXPECT_TRUE(Tips(*model, tree_of(*model)).all().empty());
}

TEST(Tips, HaveTheConesAxisAndTaper) {
  const Model model = analytic_cone(1.0, 8.0, {oblique(), 1e-3});
  const Tips tips(model, tree_of(model));
  ASSERT_EQ(tips.all().size(), 1u);
  const Tip& tip = tips.all().front();
  EXPECT_NEAR(tip.taper, 1.0 / 8.0, 1e-6);
  EXPECT_EQ(tip.lesser_taper, tip.taper);
  EXPECT_NEAR(std::abs(tip.along.dot(oblique().axes.col(2))), 1.0, 1e-9);
  EXPECT_EQ(tip.place, model.vertex(tip.vertex).point);
}

TEST(Tips, ReachAsFarAsSixPointsHaveNoRoom) {
  const Model model = analytic_cone(1.0, 8.0);
  const Octree tree = tree_of(model);
  const Tips tips(model, tree);
  ASSERT_EQ(tips.all().size(), 1u);
  const Tip& tip = tips.all().front();
  const double spacing = tree.spacing_at(tip.place + tip.reach * tip.along);
  EXPECT_GE(tip.ring_step(), 0.69 * spacing);
  EXPECT_LE(tip.ring_step(), 0.8 * spacing);
}

TEST(Tips, HaveSixPointsOnTheRingAndNoneBeyondOrInItsBall) {
  const Model model = analytic_cone(1.0, 8.0, {oblique(), 1e-3});
  const Octree tree = tree_of(model);
  const Tips tips(model, tree);
  ASSERT_EQ(tips.all().size(), 1u);
  const Tip& tip = tips.all().front();
  const Seeds seeds = test::seed_points(model, tree, kSize);
  int on_ring = 0;
  for (std::size_t i = 0; i < seeds.points.size(); ++i) {
    const Vec3 p = seeds.points.position[i];
    if (seeds.points.on[i] == model_vertex(tip.vertex)) continue;
    const double outside = distance_from_ball(tip, p);
    if (std::abs(outside) < 1e-6)
      ++on_ring;
    else
      EXPECT_GT(outside, 0.0) << p.transpose();
  }
  EXPECT_EQ(on_ring, 6);
}

TEST(Tips, MoveWhatTheyHoldToTheRingOnTheSameSideOfTheCone) {
  const Model model = analytic_cone(1.0, 8.0);
  const Tips tips(model, tree_of(model));
  ASSERT_EQ(tips.all().size(), 1u);
  const Tip& tip = tips.all().front();
  const int face = tip.faces.front();
  for (const Vec3& place : ring_places(model, tip)) {
    const Vec3 inside = model.face_project(face, tip.place + 0.4 * (place - tip.place)).point;
    EXPECT_EQ(tips.holder(face, inside), &tip);
    const std::optional<Vec3> moved = ring_point(model, tip, face, inside);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(distance_from_ball(tip, *moved), 0.0, 1e-6);
    EXPECT_LT((*moved - tip.place).cross(inside - tip.place).norm(), 1e-6);
    EXPECT_EQ(tips.holder(face, *moved), nullptr);
  }
}

}  // namespace
}  // namespace octet
