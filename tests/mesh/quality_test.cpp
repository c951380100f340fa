// SPDX-License-Identifier: BSD-3-Clause
// The measures know the regular tetrahedron and a corner of a cube, and agree that a flat one is worthless.
#include "mesh/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

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

TEST(Quality, CotangentsStandForAngles) {
  double last = std::numeric_limits<double>::infinity();
  for (const double angle : {1e-3, 0.3, 1.0, std::numbers::pi / 2, 2.0, 3.0, std::numbers::pi - 1e-3}) {
    const double cotangent = squared_cotangent(angle);
    EXPECT_LT(cotangent, last);
    EXPECT_NEAR(angle_of_cotangent(cotangent), angle, 1e-12);
    last = cotangent;
  }
  const Vec3 a(0, 0, 0), b(1, 0.2, 0), c(0.1, 0.9, -0.1), d(0.3, 0.2, 0.4);
  const DihedralCotangents cotangents = dihedral_cotangents(a, b, c, d);
  const DihedralRange range = dihedral_range(a, b, c, d);
  EXPECT_GT(range.smallest, 0.1);
  EXPECT_NEAR(cotangents.smallest, squared_cotangent(range.smallest), 1e-9);
  EXPECT_NEAR(cotangents.largest, squared_cotangent(range.largest), 1e-9);
  EXPECT_EQ(dihedral_cotangents(a, c, b, d).smallest, std::numeric_limits<double>::infinity());
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

/// Corners of cubes of all heights, the flat ones first or last: a sample sees the list as it is or not at
/// all.
TEST(Quality, TheFirstPercentileOfManyIsThatOfASortedList) {
  constexpr std::size_t kCount = 20'000;
  for (const std::size_t stride : {std::size_t{1}, std::size_t{7919}, std::size_t{64}}) {
    Mesh mesh;
    std::vector<double> angles;
    for (std::size_t i = 0; i < kCount; ++i) {
      const std::size_t n = stride == 64 ? (i % 64 == 0 ? kCount : i) : i * stride % kCount;
      const double height = 0.001 + static_cast<double>(n) / kCount;
      const auto first = static_cast<Mesh::Index>(mesh.points.size());
      for (Vec3 p : cube_corner()) mesh.points.push_back(p.cwiseProduct(Vec3(1, 1, height)));
      mesh.tets.push_back({first, first + 1, first + 2, first + 3});
      const Vec3* p = &mesh.points[first];
      angles.push_back(dihedral_range(p[0], p[1], p[2], p[3]).smallest);
    }
    std::sort(angles.begin(), angles.end());
    EXPECT_NEAR(quality_summary(mesh).p1_min_dihedral, angles[kCount / 100], 1e-12) << stride;
  }
}

}  // namespace
}  // namespace octet
