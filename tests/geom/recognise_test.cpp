// SPDX-License-Identifier: BSD-3-Clause
// Closed forms are found again behind another parametrisation.
#include "geom/recognise.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geom/quadrics.h"
#include "geom/torus.h"

namespace octet {
namespace {

Axes3 tilted() {
  const Eigen::Matrix3d m = Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  return {Vec3(30, -20, 7), m.col(0), m.col(1), m.col(2)};
}

/// `surface` over a box of its (u,v), which `s` and `t` in [0,1] traverse at uneven speed, v first.
struct Disguised {
  std::shared_ptr<const Surface> surface;
  Vec2 lo, hi;
  double bump = 0.0;

  [[nodiscard]] static Vec3 speed(double x) {  // value, first and second derivative
    return {x + 0.2 * x * (1.0 - x), 1.2 - 0.4 * x, -0.4};
  }
  [[nodiscard]] Vec2 own(const Vec2& st) const {
    return {lo.x() + (hi.x() - lo.x()) * speed(st.y())[0], lo.y() + (hi.y() - lo.y()) * speed(st.x())[0]};
  }
  [[nodiscard]] SurfaceJet operator()(const Vec2& st, int) const {
    const SurfaceJet j = surface->evaluate(own(st), 2);
    const Vec3 a = speed(st.x()) * (hi.y() - lo.y()), b = speed(st.y()) * (hi.x() - lo.x());
    SurfaceJet jet;
    jet.p = j.p + bump * std::sin(kPi * st.x()) * std::sin(kPi * st.y()) * surface->normal(own(st));
    jet.du = a[1] * j.dv;
    jet.dv = b[1] * j.du;
    jet.duu = a[1] * a[1] * j.dvv + a[2] * j.dv;
    jet.duv = a[1] * b[1] * j.duv;
    jet.dvv = b[1] * b[1] * j.duu + b[2] * j.du;
    return jet;
  }
};

const std::vector<double> kUnit{0.0, 1.0};
constexpr double kTolerance = 1e-7;

class Recognise : public ::testing::TestWithParam<int> {
 public:
  [[nodiscard]] static Disguised piece(int i) {
    const Axes3 axes = tilted();
    switch (i) {
      case 0:
        return {make_plane(axes), {-3, 1}, {5, 2}};
      case 1:
        return {make_cylinder(axes, 2.5, 0.0), {0, -4}, {2 * kPi, 9}};
      case 2:
        return {make_cylinder(axes, 40.0, 0.0), {5.9, -4}, {6.5, 9}};
      case 3:
        return {make_cone(axes, 0.3, 2.0, 0.0), {0, -1}, {2 * kPi, 5}};
      case 4:
        return {make_cone(axes, -0.6, 2.0, 0.0), {1, 0}, {3, 2.0 / std::sin(0.6)}};
      case 5:
        return {make_sphere(axes, 3.0, 0.0), {0, -0.5 * kPi}, {2 * kPi, 0.5 * kPi}};
      case 6:
        return {make_sphere(axes, 3.0, 0.0), {5, 0.2}, {7, 1.1}};
      case 7:
        return {make_torus(axes, 5.0, 2.0, 0.0, 0.0), {0, 0}, {2 * kPi, 2 * kPi}};
      case 8:  // half of it, but for caps: clear of the sphere's own axis alone
        return {make_sphere(axes, 3.0, 0.0), {0.3, -1.1}, {0.3 + kPi, 1.15}};
      case 9:
        return {make_sphere(axes, 3.0, 0.0), {0, -1.2}, {2 * kPi, 1.1}};
      default:
        return {make_torus(axes, 5.0, 2.0, 0.0, 0.0), {1, 2}, {2, 5}};
    }
  }
};

TEST_P(Recognise, GivesTheSameSurfaceNormalsAndSides) {
  const Disguised source = piece(GetParam());
  const auto form = recognise(source, kUnit, kUnit, kTolerance);
  ASSERT_TRUE(form);
  EXPECT_STREQ(form->surface().kind(), source.surface->kind());
  Vec2 last = Vec2::Zero();
  for (int i = 0; i <= 50; ++i)
    for (int j = 0; j <= 50; ++j) {
      const Vec2 st(i / 50.0, j / 50.0);
      const SurfaceJet jet = source(st, 2);
      const Vec2 uv = form->map(jet.p, st);
      EXPECT_LT((form->surface().evaluate(uv, 0).p - jet.p).norm(), 1e-10);
      const Vec3 n = jet.du.cross(jet.dv);
      if (n.norm() > 1e-6) {
        EXPECT_GT(form->surface().normal(uv).dot(n.normalized()), 1.0 - 1e-10);
      }
      if (j > 0) {
        EXPECT_LT(std::abs(uv.x() - last.x()) + std::abs(uv.y() - last.y()), 1.0)
            << "jumps at " << st.transpose();
      }
      last = uv;
    }
}

TEST_P(Recognise, IsNotFooledBySomethingNearby) {
  Disguised source = piece(GetParam());
  source.bump = 20.0 * kTolerance;
  EXPECT_FALSE(recognise(source, kUnit, kUnit, kTolerance));
}

INSTANTIATE_TEST_SUITE_P(Forms, Recognise, ::testing::Range(0, 11));

/// A sphere seen from its centre through a plane: no poles of its own, and du at the first corner points at a
/// place in the middle of it.
SurfaceJet gnomonic(const Vec2& st) {
  constexpr double kRadius = 5.0;
  const Axes3 axes = tilted();
  const Vec2 x = (st - Vec2(0.5, 0.5)).cwiseProduct(Vec2(2.4, 1.0));
  const Vec3 q = axes.z + x.x() * axes.x + x.y() * axes.y;
  const double length = q.norm();
  const Vec3 n = q / length;
  SurfaceJet jet;
  jet.p = axes.origin + kRadius * n;
  jet.du = 2.4 * kRadius / length * (axes.x - axes.x.dot(n) * n);
  jet.dv = kRadius / length * (axes.y - axes.y.dot(n) * n);
  return jet;
}

TEST(Recognise, AnAnyhowParametrisedPieceOfASphereHasNoPoleInIt) {
  const auto form = recognise([](const Vec2& st, int) { return gnomonic(st); }, kUnit, kUnit, kTolerance);
  ASSERT_TRUE(form);
  EXPECT_STREQ(form->surface().kind(), "sphere");
  constexpr int kSteps = 60;
  std::vector<Vec2> below(kSteps + 1);
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const Vec2 st(static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps);
      const Vec2 uv = form->map(gnomonic(st).p, st);
      EXPECT_LT((form->surface().evaluate(uv, 0).p - gnomonic(st).p).norm(), 1e-10);
      if (i > 0) {
        EXPECT_LT((uv - below[j]).norm(), 0.3) << "jumps at " << st.transpose();
      }
      if (j > 0) {
        EXPECT_LT((uv - below[j - 1]).norm(), 0.3) << "jumps at " << st.transpose();
      }
      below[j] = uv;
    }
}

TEST(Recognise, BothSidesOfASeamAreAPeriodApart) {
  const Disguised source = Recognise::piece(1);
  const auto form = recognise(source, kUnit, kUnit, kTolerance);
  ASSERT_TRUE(form);
  for (int i = 0; i <= 10; ++i) {
    const Vec2 left(0.1 * i, 0.0), right(0.1 * i, 1.0);
    const Vec2 a = form->map(source(left, 0).p, left), b = form->map(source(right, 0).p, right);
    EXPECT_NEAR(std::abs(b.x() - a.x()), 2.0 * kPi, 1e-9);
    EXPECT_NEAR(a.y(), b.y(), 1e-9);
  }
}

TEST(Recognise, AlongAPoleTheAngleFollowsTheSource) {
  const Disguised source = Recognise::piece(5);
  const auto form = recognise(source, kUnit, kUnit, kTolerance);
  ASSERT_TRUE(form);
  const Vec2 first(0.0, 0.0), last(0.0, 1.0);
  EXPECT_NEAR(std::abs(form->map(source(last, 0).p, last).x() - form->map(source(first, 0).p, first).x()),
              2.0 * kPi, 1e-6);
}

}  // namespace
}  // namespace octet
