// SPDX-License-Identifier: BSD-3-Clause
// Centres of gravity of bodies where they are known.
#include "geom/centroids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_models.h"

namespace octet {
namespace {

Vec3 in_frame(const Vec3& p) { return test::tilted_frame().origin + test::tilted_frame().axes * p; }

double off(const Vec3& centre, const Vec3& expected) { return (centre - in_frame(expected)).norm(); }

TEST(Centroids, OfABoxAreTheMiddlesOfItsSides) {
  const Vec3 size(2, 3, 5);
  const Model model = analytic_box(size, test::tilted());
  const Centroids centre = centroids(model);
  EXPECT_LT(off(centre.region[1], size / 2), 1e-12);
  for (int f = 1; f <= 6; ++f) {
    Vec3 mean = Vec3::Zero();
    for (const int v : model.face(f).vertices) mean += model.vertex(v).point / 4.0;
    EXPECT_LT((centre.face[static_cast<std::size_t>(f)] - mean).norm(), 1e-12) << f;
  }
}

TEST(Centroids, OfTwoBodiesAreThoseOfEach) {
  const Centroids centre = centroids(analytic_two_boxes(Vec3(2, 3, 5), test::tilted()));
  EXPECT_LT(off(centre.region[1], Vec3(1, 1.5, 2.5)), 1e-12);
  EXPECT_LT(off(centre.region[2], Vec3(3, 1.5, 2.5)), 1e-12);
}

TEST(Centroids, OfAWedgeAreAThirdOfTheWay) {
  const double angle = 0.8;
  const Centroids centre = centroids(analytic_wedge(angle, 6.0, 4.0, test::tilted()));
  EXPECT_LT(off(centre.region[1], Vec3(2.0 + 2.0 * std::cos(angle), 2.0 * std::sin(angle), 2.0)), 1e-12);
}

// Facets off by a tenth of the radius, whose own centres are off by far more.
TEST(Centroids, OfRoundBodiesAreThoseOfTheExactSurface) {
  const Model cone = analytic_cone(2.0, 8.0, test::tilted());
  const Centroids centre = centroids(cone);
  EXPECT_LT(off(centre.region[1], Vec3(0, 0, 2.0)), 1e-5);
  for (int f = 1; f <= cone.count(2); ++f)
    EXPECT_LT(off(centre.face[static_cast<std::size_t>(f)], Vec3(0, 0, cone.is_plane(f) ? 0.0 : 8.0 / 3.0)),
              cone.is_plane(f) ? 1e-12 : 1e-5);
  EXPECT_LT(off(centroids(analytic_ball(2.0, test::tilted())).region[1], Vec3::Zero()), 1e-5);
  EXPECT_LT(off(centroids(analytic_torus(5.0, 2.0, test::tilted())).face[1], Vec3::Zero()), 1e-5);
}

}  // namespace
}  // namespace octet
