// SPDX-License-Identifier: BSD-3-Clause
// The measures know the regular tetrahedron and a corner of a cube, and agree that a flat one is worthless.
#include "mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octet {
namespace {

using Corners = std::array<Vec3, 4>;

Corners regular() { return {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}; }
Corners cube_corner() { return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}; }

TEST(Quality, TheRegularTetrahedronHasRatioOneInEveryMeasure) {
  Corners c = regular();
  if (signed_volume(c[0], c[1], c[2], c[3]) < 0.0) std::swap(c[2], c[3]);
  EXPECT_NEAR(mean_ratio(c[0], c[1], c[2], c[3]), 1.0, 1e-14);
  EXPECT_NEAR(radius_ratio(c[0], c[1], c[2], c[3]), 1.0, 1e-14);
  EXPECT_NEAR(aspect(c[0], c[1], c[2], c[3]), 1.0, 1e-14);
  EXPECT_NEAR(dihedral_range(c[0], c[1], c[2], c[3]).smallest, std::acos(1.0 / 3.0), 1e-14);
}

TEST(Quality, TheCornerOfACubeHasItsClosedForms) {
  const Corners c = cube_corner();
  EXPECT_NEAR(mean_ratio(c[0], c[1], c[2], c[3]), 12.0 * std::cbrt(0.25) / 9.0, 1e-14);
  for (const double scale : {1e-60, 3e-9, 7.0, 2e11, 1e60})
    EXPECT_NEAR(mean_ratio(scale * c[0], scale * c[1], scale * c[2], scale * c[3]),
                12.0 * std::cbrt(0.25) / 9.0, 1e-14);
  // r = 1 / (3 + sqrt 3), R = sqrt(3) / 2.
  EXPECT_NEAR(radius_ratio(c[0], c[1], c[2], c[3]), 6.0 / ((3.0 + std::sqrt(3.0)) * std::sqrt(3.0)), 1e-14);
  EXPECT_NEAR(aspect(c[0], c[1], c[2], c[3]), std::sqrt(1.5) / std::sqrt(3.0) / std::sqrt(2.0), 1e-14);
}

TEST(Quality, FlatAndTurnedTetrahedraAreWorthNothing) {
  const Corners c = cube_corner();
  const Vec3 flat(0.3, 0.3, 0.0);
  EXPECT_EQ(mean_ratio(c[0], c[1], c[2], flat), 0.0);
  EXPECT_EQ(radius_ratio(c[0], c[1], c[2], flat), 0.0);
  EXPECT_EQ(aspect(c[0], c[1], c[2], flat), 0.0);
  EXPECT_EQ(radius_ratio(c[1], c[0], c[2], c[3]), 0.0);
  EXPECT_EQ(aspect(c[1], c[0], c[2], c[3]), 0.0);
}

}  // namespace
}  // namespace octet
