// SPDX-License-Identifier: BSD-3-Clause
// Axes that turn with the part.
#include "geom/own_axes.h"

#include <gtest/gtest.h>

#include "geom/model_check.h"
#include "geom/turned_model.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using Turn = Eigen::Matrix3d;

Turn some_turn() { return test::tilted_frame().axes; }

TEST(OwnAxes, TurnWithThePart) {
  const Turn turn = some_turn();
  for (const test::Sample& sample : test::all_samples()) {
    if (sample.name == "ball" || sample.name == "hollow ball") continue;
    const Turn still = own_axes(sample.model), turned = own_axes(turned_model(sample.model, turn));
    if (sample.name == "torus") {  // a body of revolution has but one axis, which may point either way
      EXPECT_LT((turned * turn).row(0).cross(still.row(0)).norm(), 1e-8);
      continue;
    }
    EXPECT_LT((turned * turn - still).cwiseAbs().maxCoeff(), 1e-8) << sample.name;
  }
}

TEST(OwnAxes, AreARotation) {
  for (const test::Sample& sample : test::all_samples(test::tilted_frame())) {
    const Turn axes = own_axes(sample.model);
    EXPECT_LT((axes * axes.transpose() - Turn::Identity()).cwiseAbs().maxCoeff(), 1e-14) << sample.name;
    EXPECT_GT(axes.determinant(), 0.0) << sample.name;
  }
}

TEST(OwnAxes, AreARotationWhereOneOfThemIsNearlyAtRightAnglesToACoordinateAxis) {
  Landmarks landmarks;
  const Vec3 first = Vec3(-0.06, -0.67, 0.74).normalized();
  landmarks.add_plane(first, 2.0);
  landmarks.add_plane(first.cross(Vec3::UnitZ() + Vec3(3e-10, 0.0, 0.0)).normalized(), 1.0);
  ASSERT_NE(landmarks.planes[1].normal.z(), 0.0);
  const Turn axes = own_axes(landmarks);
  EXPECT_LT((axes * axes.transpose() - Turn::Identity()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(OwnAxes, OfABoxAlongTheCoordinateAxesAreExactlyThose) {
  const Turn axes = own_axes(analytic_box(Vec3(3, 1, 2)));
  EXPECT_EQ((axes.array().abs() == 1.0).count(), 3);
  // The largest faces, 3 by 2, are normal to y, the next, 3 by 1, to z.
  EXPECT_EQ(std::abs(axes(0, 1)), 1.0);
  EXPECT_EQ(std::abs(axes(1, 2)), 1.0);
}

TEST(TurnedModel, AnswersAsTheModelDoesFromItsNewPlace) {
  const Turn turn = some_turn();
  for (const test::Sample& sample : test::all_samples()) {
    const Model turned = turned_model(sample.model, turn);
    EXPECT_EQ(check_model(turned), check_model(sample.model)) << sample.name;
    test::Dice dice(11);
    const Box3 box = sample.model.box().grown(0.2);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = dice.in(box), q = dice.in(box);
      EXPECT_EQ(turned.region_at(turn * p), sample.model.region_at(p));
      std::vector<Hit> here, there;
      sample.model.intersect(p, q, here);
      turned.intersect(turn * p, turn * q, there);
      ASSERT_EQ(here.size(), there.size()) << sample.name;
      for (std::size_t k = 0; k < here.size(); ++k) {
        EXPECT_EQ(here[k].on, there[k].on);
        EXPECT_LT((turn * here[k].point - there[k].point).norm(), 1e-11);
        EXPECT_LT((turn * here[k].normal - there[k].normal).norm(), 1e-11);
      }
    }
  }
}

TEST(TurnedModel, CutsItsEdgesByPlanes) {
  const Turn turn = some_turn();
  const Model model = analytic_cylinder(1.0, 2.5);
  const Model turned = turned_model(model, turn);
  const Vec3 normal = Vec3(1, 2, -1).normalized();
  for (int e = 1; e <= model.count(1); ++e) {
    std::vector<double> here, there;
    model.curve(e).cut(normal, 0.3, here);
    turned.curve(e).cut(turn * normal, 0.3, there);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(here[k], there[k], 1e-12);
  }
}

}  // namespace
}  // namespace octet
