// SPDX-License-Identifier: BSD-3-Clause
// The nearest vertex's size, as a look at all of them finds it.
#include "mesh/size_lookup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octet {
namespace {

/// Points that fill a box of these sides, unevenly.
std::vector<Vec3> scattered(const Vec3& sides, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const auto share = [&](double step) { return i * step - std::floor(i * step); };
    points.push_back(
        Vec3(share(0.618034) * share(0.618034), share(0.754878), share(0.569840)).cwiseProduct(sides));
  }
  return points;
}

TEST(SizeLookup, FindsTheNearestOfAllPointsInsideAndOutsideOfTheirBox) {
  for (const Vec3& sides : {Vec3(1, 1, 1), Vec3(100, 1, 1), Vec3(3, 2, 0), Vec3(0, 0, 0)}) {
    const std::vector<Vec3> points = scattered(sides, 300);
    std::vector<double> size;
    for (std::size_t i = 0; i < points.size(); ++i) size.push_back(static_cast<double>(i + 1));
    const SizeLookup lookup(points, size);
    for (const Vec3& p : scattered(2.0 * sides + Vec3::Constant(0.5), 200)) {
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < points.size(); ++i) {
        if ((points[i] - p).squaredNorm() < (points[nearest] - p).squaredNorm()) nearest = i;
      }
      EXPECT_EQ(lookup.at(p), size[nearest]);
    }
  }
}

}  // namespace
}  // namespace octet
