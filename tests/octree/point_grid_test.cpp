// SPDX-License-Identifier: BSD-3-Clause
// PointGrid finds exactly the points that a scan of all points finds.
#include "octree/point_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace octet {
namespace {

TEST(PointGrid, FindsExactlyThePointsWithinTheRadius) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0.0, 16.0);
  PointGrid grid(Vec3::Zero(), 16.0);
  std::vector<Vec3> points;
  for (std::uint32_t n = 0; n < 2000; ++n) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
    grid.add(n, points.back(), n % 3 == 0 ? 0.1 : 1.0);
  }
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = points[i * 7];
    const double r = 0.05 + 0.01 * i;
    std::set<std::uint32_t> found, expected;
    grid.any_within(p, r, [&](std::uint32_t n, double) {
      found.insert(n);
      return false;
    });
    for (std::uint32_t n = 0; n < points.size(); ++n)
      if ((points[n] - p).squaredNorm() < r * r) expected.insert(n);
    EXPECT_EQ(found, expected);
  }
}

TEST(PointGrid, FindsTheBallsAroundAPlaceAndPassesSmallOnesBy) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(0.0, 16.0), magnitude(-7.0, 0.7);
  PointGrid grid(Vec3::Zero(), 16.0);
  std::vector<Vec3> middles;
  std::vector<double> diameters;
  for (std::uint32_t n = 0; n < 4000; ++n) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    middles.emplace_back(x, y, z);
    diameters.push_back(std::pow(10.0, magnitude(random)));
    grid.add(n, middles.back(), diameters.back());
  }
  for (std::uint32_t i = 0; i < 400; ++i) {
    // Every other place is within a ball of its own, however small that is.
    const Vec3 p = middles[i] + (i % 2 == 0 ? 0.4 * diameters[i] : 0.3) * Vec3::UnitX();
    const double r = 1e-3 * (1 + 5 * i);
    const auto is_around = [&](std::uint32_t n) {
      const double d = (middles[n] - p).norm();
      return d < r && d < 0.5 * diameters[n];
    };
    std::set<std::uint32_t> found, expected;
    grid.any_around(p, r, [&](std::uint32_t n, double) {
      if (is_around(n)) found.insert(n);
      return false;
    });
    for (std::uint32_t n = 0; n < middles.size(); ++n)
      if (is_around(n)) expected.insert(n);
    EXPECT_EQ(found, expected);
  }

  PointGrid beside(Vec3::Zero(), 16.0);
  for (std::uint32_t n = 0; n < 1000; ++n) beside.add(n, Vec3(1.0 + 1e-3 * n, 1.0, 1.0), 1e-3);
  int visits = 0;
  beside.any_around(Vec3(1.5, 1.1, 1.0), 1.0, [&](std::uint32_t, double) {
    ++visits;
    return false;
  });
  EXPECT_EQ(visits, 0);
}

TEST(PointGrid, StopsWhenTheVisitorSaysSo) {
  PointGrid grid(Vec3::Zero(), 1.0);
  grid.add(0, Vec3(0.5, 0.5, 0.5), 0.1);
  grid.add(1, Vec3(0.52, 0.5, 0.5), 0.1);
  int visits = 0;
  EXPECT_TRUE(
      grid.any_within(Vec3(0.5, 0.5, 0.5), 0.1, [&](std::uint32_t, double) { return ++visits == 1; }));
  EXPECT_EQ(visits, 1);
  EXPECT_FALSE(grid.any_within(Vec3(0.1, 0.1, 0.1), 0.1, [](std::uint32_t, double) { return true; }));
}

}  // namespace
}  // namespace octet
