// SPDX-License-Identifier: BSD-3-Clause
// The distortion is the mean ratio to the power -3/2, its derivatives are right, and it is convex.
#include "finalize/mean_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "mesh/quality.h"
#include "tests/finalize/builders.h"

namespace octet {
namespace {

struct Base {
  Vec3 x, y, z;
  [[nodiscard]] double at(const Vec3& p) const { return distortion(x, y, z, p); }
  [[nodiscard]] Distortion derivatives(const Vec3& p) const {
    Distortion d;
    EXPECT_TRUE(add_distortion(x, y, z, p, d));
    return d;
  }
};

class MeanShape : public ::testing::Test {
 protected:
  Vec3 random() {
    const double x = dice_.roll(), y = dice_.roll(), z = dice_.roll();
    return {x, y, z};
  }
  /// A base in the plane z = 0, and a place above it.
  Base random_base() {
    Base base{random(), random(), random()};
    base.x.z() = base.y.z() = base.z.z() = 0.0;
    if ((base.y - base.x).cross(base.z - base.x).z() < 0.0) std::swap(base.y, base.z);
    return base;
  }
  testing::Dice dice_{3};
};

TEST_F(MeanShape, IsThePowerOfTheMeanRatio) {
  for (int i = 0; i < 100; ++i) {
    const Base base = random_base();
    const Vec3 p = random() + Vec3(0, 0, 0.1);
    const double ratio = mean_ratio(base.x, base.y, base.z, p);
    EXPECT_NEAR(base.at(p) * std::pow(ratio, 1.5), 1.0, 1e-9);
    EXPECT_NEAR(base.derivatives(p).value / base.at(p), 1.0, 1e-12);
  }
}

TEST_F(MeanShape, IsInfiniteWithoutVolume) {
  const Base base{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Distortion d;
  for (const double z : {0.0, -0.5}) {
    EXPECT_TRUE(std::isinf(base.at(Vec3(0.2, 0.2, z))));
    EXPECT_FALSE(add_distortion(base.x, base.y, base.z, Vec3(0.2, 0.2, z), d));
  }
  EXPECT_EQ(d.value, 0.0);
}

TEST_F(MeanShape, HasTheDerivativesOfDifferencesAndIsConvex) {
  const double step = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const Base base{Vec3(0, 0, 0), Vec3(1, 0.1, 0), Vec3(0.2, 0.8, 0.1)};
    const Vec3 p = random() + Vec3(0, 0, 0.3);
    const Distortion d = base.derivatives(p);
    const Mat3 hessian = d.hessian.selfadjointView<Eigen::Upper>();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 e = step * Vec3::Unit(axis);
      EXPECT_NEAR(d.gradient[axis], (base.at(p + e) - base.at(p - e)) / (2.0 * step), 1e-5 * (1.0 + d.value));
      const Vec3 row = (base.derivatives(p + e).gradient - base.derivatives(p - e).gradient) / (2.0 * step);
      EXPECT_LT((hessian.col(axis) - row).norm(), 1e-5 * (1.0 + hessian.norm()));
    }
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(hessian).eigenvalues()[0], 0.0);
  }
}

TEST_F(MeanShape, MeritIsPositiveForTheRegularTetrahedronAndFallsWithTheShape) {
  EXPECT_NEAR(merit(Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)), kMeritOfPerfect,
              1e-12);
  EXPECT_LT(merit(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 0.1)), 0.0);
}

}  // namespace
}  // namespace octet
