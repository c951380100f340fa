// SPDX-License-Identifier: BSD-3-Clause
// Circumcentres are right where they are called reliable, and noise-flat tetrahedra are told apart.
#include "mesh/circumcentre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace octet {
namespace {

class Random {
 public:
  double real() { return 2.0 * (static_cast<double>(engine_()) / 4294967296.0) - 1.0; }
  Vec3 vec() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }

 private:
  std::mt19937 engine_{1};
};

TEST(Circumcentre, IsThatOfTheUnitTetrahedron) {
  const Circumcentre c = circumcentre({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_TRUE(c.reliable);
  EXPECT_EQ(c.point, Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(c.squared_radius, 0.75);
}

TEST(Circumcentre, FindsTheCentreItsPointsWereMadeFrom) {
  Random random;
  for (int n = 0; n < 10000; ++n) {
    const Vec3 centre = 100 * random.vec();
    const double r = std::pow(10.0, 3 * random.real() - 1);
    Vec3 p[4];
    for (Vec3& q : p) q = centre + r * random.vec().normalized();
    const Circumcentre c = circumcentre(p[0], p[1], p[2], p[3]);
    if (!c.reliable) continue;
    // The points are rounded to 100 * 2^-53, which a flat tetrahedron magnifies up to the noise margin.
    ASSERT_LT((c.point - centre).norm(), 0.01 * r);
    ASSERT_NEAR(std::sqrt(c.squared_radius), r, 0.01 * r);
  }
}

TEST(Circumcentre, OrdinaryTetrahedraAreReliable) {
  Random random;
  for (int n = 0; n < 1000; ++n) {
    const Vec3 at = 100 * random.vec();
    const double h = 1e-3;
    const Circumcentre c =
        circumcentre(at, at + h * Vec3(1, 0.1, 0), at + h * Vec3(0, 1, 0.1), at + h * Vec3(0.1, 0, 0.1));
    ASSERT_TRUE(c.reliable);
  }
}

TEST(Circumcentre, PointsRoundedOntoAnObliquePlaneAreNot) {
  Random random;
  for (int n = 0; n < 10000; ++n) {
    const Vec3 at = 100 * random.vec();
    const Vec3 u = random.vec().normalized(), v = u.cross(random.vec()).normalized();
    const double h = std::pow(10.0, 2 * random.real() - 1);
    Vec3 p[4];
    for (Vec3& q : p) {
      const double s = random.real(), t = random.real();
      q = at + h * (s * u + t * v);
    }
    ASSERT_FALSE(circumcentre(p[0], p[1], p[2], p[3]).reliable);
  }
}

TEST(Circumcentre, CoplanarPointsHaveAnInfiniteSphere) {
  const Circumcentre c = circumcentre({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1});
  EXPECT_FALSE(c.reliable);
  EXPECT_TRUE(std::isinf(c.squared_radius));
}

}  // namespace
}  // namespace octet
