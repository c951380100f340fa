// SPDX-License-Identifier: BSD-3-Clause
// What a part gets does not depend on how it lies.
#include "app/own_frame.h"

#include <gtest/gtest.h>

#include "geom/analytic.h"

namespace octet {
namespace {

AnalyticOptions turned_far(double angle = 0.7) {
  AnalyticOptions options;
  options.frame.origin = Vec3(5.0, -7.0, 11.0);
  options.frame.axes =
      (Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-1.1, Vec3::UnitX()))
          .toRotationMatrix();
  return options;
}

void expect_same(const Model& one, const Model& other) {
  const MeshResult a = mesh_part(one), b = mesh_part(other);
  EXPECT_EQ(a.report.status, MeshStatus::kComplete);
  EXPECT_EQ(b.report.status, MeshStatus::kComplete);
  EXPECT_NEAR(a.report.size, b.report.size, 1e-3 * a.report.size);
  EXPECT_NEAR(static_cast<double>(a.report.tets), static_cast<double>(b.report.tets),
              0.03 * static_cast<double>(a.report.tets));
}

TEST(OwnFrame, HoweverAPartIsTurnedItGetsTheSameSizeAndElements) {
  expect_same(analytic_box(Vec3(1, 2, 3), turned_far(2.0)), analytic_box(Vec3(1, 2, 3), turned_far()));
  expect_same(analytic_box(Vec3(3, 3, 0.25), turned_far(2.0)), analytic_box(Vec3(3, 3, 0.25), turned_far()));
  expect_same(analytic_cone(1.0, 2.0, turned_far(2.0)), analytic_cone(1.0, 2.0, turned_far()));
}

TEST(OwnFrame, APartAlongTheCoordinateAxesGetsWhatItGetsTurned) {
  AnalyticOptions lying;
  lying.frame.axes = Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()).toRotationMatrix();
  for (const Vec3& size : {Vec3(1, 2, 3), Vec3(0.4, 3, 2)}) {
    expect_same(analytic_box(size), analytic_box(size, turned_far()));
    expect_same(analytic_box(size), analytic_box(size, lying));
  }
}

TEST(OwnFrame, AThinPlateIsTriangulatedAlikeHoweverItLies) {
  // Its sheets hold the same points, whose boxes are all ties: noise must not decide on their diagonals.
  const Vec3 size(20.0, 17.0, 0.9);
  AnalyticOptions moved;
  moved.frame.origin = Vec3(0.1, 0.2, 0.3);
  const Model still = analytic_box(size, moved), turned = analytic_box(size, turned_far());
  MeshOptions options;
  options.size = 1.5;
  options.finalize = false;
  const MeshResult a = mesh_part(still, options), b = mesh_part(turned, options);
  EXPECT_EQ(a.report.status, MeshStatus::kComplete);
  EXPECT_EQ(b.report.status, MeshStatus::kComplete);
  EXPECT_NEAR(static_cast<double>(a.report.tets), static_cast<double>(b.report.tets),
              0.002 * static_cast<double>(a.report.tets));
  options.finalize = true;
  for (const Model* model : {&still, &turned}) {
    const MeshResult result = mesh_part(*model, options);
    EXPECT_EQ(result.report.status, MeshStatus::kComplete);
    EXPECT_GT(result.report.quality.mean_mean_ratio, 0.8);
    for (const Vec3& p : result.mesh.points) {
      if (model == &turned || p.z() > 0.31) continue;
      EXPECT_NEAR(p.z(), 0.3, 1e-15) << "rounding is for the triangulation alone";
    }
  }
}

TEST(OwnFrame, NothingIsTurnedAlongItsOwnAxesOrWithSizesOverSpace) {
  const Model still = analytic_box(Vec3(1, 2, 3));
  const OwnFrame standing(still, {});
  EXPECT_EQ(&standing.model(), &still);
  const Model turned = analytic_box(Vec3(1, 3, 2), turned_far());
  EXPECT_NE(&OwnFrame(turned, {}).model(), &turned);
  MeshOptions options;
  options.attributes.push_back(parse_size_attribute("ball:5,-7,11,1=0.2"));
  const OwnFrame over_space(turned, options);
  EXPECT_EQ(&over_space.model(), &turned);
}

TEST(OwnFrame, TheEntityNearestToAPlaceIsTheSame) {
  const Model turned = analytic_box(Vec3(1, 3, 2), turned_far());
  MeshOptions options;
  const Vec3 place = turned.face_closest(3, turned.box().centre()).point;
  SizeAttribute nearest;
  nearest.where = SizeAttribute::Where::kNearest;
  nearest.dim = 2;
  nearest.a = place;
  nearest.size = 0.1;
  options.attributes.push_back(nearest);
  const OwnFrame frame(turned, options);
  EXPECT_EQ(selected_entities(frame.model(), frame.options().attributes.front()),
            selected_entities(turned, nearest));
  EXPECT_LT((frame.to_part(frame.to_model(place)) - place).norm(), 1e-13);
}

}  // namespace
}  // namespace octet
