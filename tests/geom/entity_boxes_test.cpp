// SPDX-License-Identifier: BSD-3-Clause
// Boxes of bodies that lie askew.
#include "geom/entity_boxes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_models.h"

namespace octet {
namespace {

void expect_box(const Box3& box, const Vec3& centre, const Vec3& half) {
  EXPECT_LT((box.centre() - centre).norm(), 1e-9);
  EXPECT_LT((0.5 * box.size() - half).norm(), 1e-9);
}

/// How far a circle of radius 1 about an axis reaches along x, y and z.
Vec3 circle_reach(const Vec3& axis) {
  return axis.unaryExpr([](double c) { return std::sqrt(1.0 - c * c); });
}

TEST(EntityBoxes, OfACylinderAreThoseOfItsEndsTogether) {
  const Frame frame = test::tilted_frame();
  const Vec3 axis = frame.axes.col(2);
  const EntityBoxes boxes = entity_boxes(analytic_cylinder(2.0, 7.0, test::tilted()));
  const Vec3 half = 2.0 * circle_reach(axis) + 3.5 * axis.cwiseAbs();
  expect_box(boxes.region[1], frame.origin + 3.5 * axis, half);
  Box3 sides;
  for (std::size_t f = 1; f < boxes.face.size(); ++f) {
    sides.add(boxes.face[f]);
    EXPECT_LE((boxes.face[f].size() - 2.0 * half).maxCoeff(), 1e-9);
  }
  expect_box(sides, frame.origin + 3.5 * axis, half);
}

TEST(EntityBoxes, OfASphereReachToWhereItTurnsBack) {
  const EntityBoxes boxes = entity_boxes(analytic_ball(2.0, test::tilted()));
  expect_box(boxes.face[1], test::tilted_frame().origin, Vec3::Constant(2.0));
}

TEST(EntityBoxes, OfATorusReachToWhereItTurnsBack) {
  const EntityBoxes boxes = entity_boxes(analytic_torus(5.0, 1.0, test::tilted()));
  const Vec3 half = 5.0 * circle_reach(test::tilted_frame().axes.col(2)) + Vec3::Ones();
  expect_box(boxes.face[1], test::tilted_frame().origin, half);
}

TEST(EntityBoxes, OfEdgesAreTight) {
  const Model model = analytic_cone(2.0, 5.0, test::tilted());
  const EntityBoxes boxes = entity_boxes(model);
  const Frame frame = test::tilted_frame();
  for (int e = 1; e <= model.count(1); ++e) {
    const Box3& box = boxes.edge[static_cast<std::size_t>(e)];
    if (model.edge(e).use == EdgeUse::kDegenerate)
      EXPECT_TRUE(box.empty());
    else if (model.edge(e).use == EdgeUse::kReal)
      expect_box(box, frame.origin, 2.0 * circle_reach(frame.axes.col(2)));
  }
}

}  // namespace
}  // namespace octet
