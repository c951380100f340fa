// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of quadrics and torus: every root lies on the surface, and none is missed.
#include "geom/quadrics.h"

#include <gtest/gtest.h>

#include "geom/torus.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

struct Case {
  std::string name;
  std::shared_ptr<const Surface> surface;
  std::function<double(const Vec3&)> level;  ///< of local points; changes sign at the surface
  Axes3 axes;
  Vec2 lo, hi;  ///< a (u,v) box to sample
};

std::vector<Case> all_cases(bool left_handed) {
  const Frame f = test::tilted_frame();
  Axes3 axes{f.origin, f.axes.col(0), f.axes.col(1), f.axes.col(2)};
  if (left_handed) axes.y = -axes.y;
  const double u0 = 0.75, a = -0.4;
  return {
      {"plane", make_plane(axes), [](const Vec3& p) { return p.z(); }, axes, Vec2(-2, -2), Vec2(2, 2)},
      {"cylinder", make_cylinder(axes, 1.5, u0), [](const Vec3& p) { return p.head<2>().norm() - 1.5; }, axes,
       Vec2(u0, -2), Vec2(u0 + kTwoPi, 2)},
      {"cone", make_cone(axes, a, 1.0, u0),
       [a](const Vec3& p) { return p.head<2>().norm() - std::abs(1.0 + p.z() * std::tan(a)); }, axes,
       Vec2(u0, -2), Vec2(u0 + kTwoPi, 2)},
      {"sphere", make_sphere(axes, 1.5, u0), [](const Vec3& p) { return p.norm() - 1.5; }, axes,
       Vec2(u0, -1.5), Vec2(u0 + kTwoPi, 1.5)},
      {"torus", make_torus(axes, 1.5, 0.4, u0, -1.0),
       [](const Vec3& p) { return std::hypot(p.head<2>().norm() - 1.5, p.z()) - 0.4; }, axes, Vec2(u0, -1.0),
       Vec2(u0 + kTwoPi, -1.0 + kTwoPi)},
  };
}

std::vector<Case> both_hands() {
  std::vector<Case> cases = all_cases(false);
  for (Case& c : all_cases(true)) cases.push_back(std::move(c));
  return cases;
}

TEST(Quadrics, PointsLieOnTheLevelSet) {
  for (const Case& c : both_hands()) {
    Dice dice(1);
    for (int i = 0; i < 200; ++i) {
      const Vec2 uv(dice(c.lo.x(), c.hi.x()), dice(c.lo.y(), c.hi.y()));
      EXPECT_NEAR(c.level(c.axes.to_local(c.surface->evaluate(uv, 0).p)), 0.0, 1e-13) << c.name;
    }
  }
}

TEST(Quadrics, DerivativesAreLimitsOfDifferences) {
  constexpr double kStep = 1e-5;
  for (const Case& c : both_hands()) {
    Dice dice(2);
    for (int i = 0; i < 100; ++i) {
      const Vec2 uv(dice(c.lo.x(), c.hi.x()), dice(c.lo.y(), c.hi.y()));
      const Vec2 du(kStep, 0), dv(0, kStep);
      const auto at = [&](const Vec2& x) { return c.surface->evaluate(x, 1); };
      const SurfaceJet j = c.surface->evaluate(uv, 2);
      const double tol = 1e-8;
      EXPECT_LT(((at(uv + du).p - at(uv - du).p) / (2 * kStep) - j.du).norm(), tol) << c.name;
      EXPECT_LT(((at(uv + dv).p - at(uv - dv).p) / (2 * kStep) - j.dv).norm(), tol) << c.name;
      EXPECT_LT(((at(uv + du).du - at(uv - du).du) / (2 * kStep) - j.duu).norm(), tol) << c.name;
      EXPECT_LT(((at(uv + dv).du - at(uv - dv).du) / (2 * kStep) - j.duv).norm(), tol) << c.name;
      EXPECT_LT(((at(uv + dv).dv - at(uv - dv).dv) / (2 * kStep) - j.dvv).norm(), tol) << c.name;
      EXPECT_LT((j.du.cross(j.dv).normalized() - c.surface->normal(uv)).norm(), 1e-12) << c.name;
    }
  }
}

TEST(Quadrics, EveryRootLiesOnTheSurfaceAtItsParameters) {
  for (const Case& c : both_hands()) {
    Dice dice(3);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = c.axes.to_world(dice.vec(Vec3::Constant(-2.5), Vec3::Constant(2.5)));
      const Vec3 q = c.axes.to_world(dice.vec(Vec3::Constant(-2.5), Vec3::Constant(2.5)));
      std::vector<SurfaceRoot> roots;
      c.surface->intersect(p, q, roots);
      for (const SurfaceRoot& r : roots) {
        ++found;
        ASSERT_GE(r.t, 0.0);
        ASSERT_LE(r.t, 1.0);
        ASSERT_LT((c.surface->evaluate(r.uv, 0).p - (p + r.t * (q - p))).norm(), 1e-12) << c.name;
        if (c.name != "plane") {
          ASSERT_GE(r.uv.x(), c.lo.x());
          ASSERT_LE(r.uv.x(), c.hi.x());
        }
      }
    }
    EXPECT_GT(found, 500) << c.name;
  }
}

TEST(Quadrics, NoRootIsMissedByASegmentSampledDensely) {
  for (const Case& c : both_hands()) {
    Dice dice(4);
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = dice.vec(Vec3::Constant(-2.2), Vec3::Constant(2.2));
      const Vec3 q = dice.vec(Vec3::Constant(-2.2), Vec3::Constant(2.2));
      std::vector<SurfaceRoot> roots;
      c.surface->intersect(c.axes.to_world(p), c.axes.to_world(q), roots);
      std::size_t changes = 0;
      constexpr int kSteps = 1500;
      for (int k = 0; k < kSteps; ++k)
        changes += (c.level(p + (q - p) * k / kSteps) > 0) != (c.level(p + (q - p) * (k + 1) / kSteps) > 0);
      ASSERT_GE(roots.size(), changes) << c.name;
      ASSERT_EQ((roots.size() - changes) % 2, 0u) << c.name;
    }
  }
}

TEST(Quadrics, ProjectionsAreNoFartherThanAnySample) {
  for (const Case& c : both_hands()) {
    if (c.name == "cone") continue;  // two nappes: tested below
    Dice dice(5);
    std::vector<Vec3> samples;
    for (int i = 0; i < 2000; ++i)
      samples.push_back(c.surface->evaluate(Vec2(dice(c.lo.x(), c.hi.x()), dice(c.lo.y(), c.hi.y())), 0).p);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = c.axes.to_world(dice.vec(Vec3::Constant(-3), Vec3::Constant(3)));
      const SurfaceFoot foot = c.surface->project(p, 0.5 * (c.lo + c.hi));
      EXPECT_TRUE(foot.converged);
      EXPECT_LT((c.surface->evaluate(foot.uv, 0).p - foot.point).norm(), 1e-12) << c.name;
      double best = 1e9;
      for (const Vec3& s : samples) best = std::min(best, (s - p).norm());
      EXPECT_LE((foot.point - p).norm(), best + 1e-12) << c.name;
    }
  }
}

TEST(Quadrics, ConeFeetStayOnTheNappeOfTheSeed) {
  const auto cone = make_cone({}, -std::atan(1.0), 1.0);
  const Vec2 seed(0.0, 0.5);
  EXPECT_LT((cone->project(Vec3(0, 0, 3), seed).point - Vec3(0, 0, 1)).norm(), 1e-14);
  EXPECT_LT((cone->project(Vec3(1, 0, 1), seed).point - Vec3(0.5, 0, 0.5)).norm(), 1e-14);
  EXPECT_NEAR(cone->project(Vec3(0, -1, 0.5), seed).uv.x(), 1.5 * std::numbers::pi, 1e-14);
}

TEST(Quadrics, TouchingSegmentsGiveOneTangentRoot) {
  const auto sphere = make_sphere({}, 1.0);
  const auto cylinder = make_cylinder({}, 1.0);
  for (const auto& s : {sphere, cylinder}) {
    std::vector<SurfaceRoot> roots;
    s->intersect(Vec3(-1, 1, 0), Vec3(2, 1, 0), roots);
    ASSERT_EQ(roots.size(), 1u) << s->kind();
    EXPECT_TRUE(roots[0].tangent);
    EXPECT_NEAR(roots[0].t, 1.0 / 3.0, 1e-14);
    roots.clear();
    s->intersect(Vec3(-1, 1 - 1e-12, 0), Vec3(2, 1 - 1e-12, 0), roots);
    ASSERT_EQ(roots.size(), 2u) << s->kind();
    EXPECT_FALSE(roots[0].tangent);
  }
}

TEST(Quadrics, SegmentsInTheSurfaceAreCoincident) {
  const auto cylinder = make_cylinder({}, 1.0);
  const auto cone = make_cone({}, -std::atan(1.0), 1.0);
  std::vector<SurfaceRoot> roots;
  cylinder->intersect(Vec3(0, 1, 0), Vec3(0, 1, 3), roots);
  cone->intersect(Vec3(1, 0, 0), Vec3(0.25, 0, 0.75), roots);
  ASSERT_EQ(roots.size(), 4u);
  for (const SurfaceRoot& r : roots) EXPECT_TRUE(r.coincident);
}

TEST(Torus, HardTangenciesAreCountedRight) {
  const auto torus = make_torus({}, 2.0, 0.5);
  const auto count = [&](const Vec3& p, const Vec3& q) {
    std::vector<SurfaceRoot> roots;
    torus->intersect(p, q, roots);
    return roots;
  };
  // Fourth order contact with the top circle.
  auto roots = count(Vec3(-1, 2, 0.5), Vec3(1.3, 2, 0.5));
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_TRUE(roots[0].tangent);
  // A line that touches the top circle twice from above, then passes just below it.
  roots = count(Vec3(-4, 0, 0.5), Vec3(4, 0, 0.5));
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_TRUE(roots[0].tangent && roots[1].tangent);
  EXPECT_EQ(count(Vec3(-4, 0, 0.5 - 1e-10), Vec3(4, 0, 0.5 - 1e-10)).size(), 4u);
  EXPECT_EQ(count(Vec3(-4, 0, 0.5 + 1e-10), Vec3(4, 0, 0.5 + 1e-10)).size(), 0u);
  // The inner equator, touched from the hole: two more roots far off.
  roots = count(Vec3(-4, 1.5, 0), Vec3(4, 1.5, 0));
  ASSERT_EQ(roots.size(), 3u);
  EXPECT_TRUE(roots[1].tangent);
  EXPECT_EQ(count(Vec3(-4, 0, 0), Vec3(4, 0, 0)).size(), 4u);
}

/// A fillet's corner is a torus whose spine is a circle of a millionth, where radii differ by rounding.
TEST(Torus, BothSheetsOfOneThatIsAllButASphereAreCrossed) {
  constexpr double kMinor = 10.0;
  for (const double major : {1e-3, 1e-5, 1e-6, 1e-8}) {
    const auto torus =
        make_torus({Vec3(12, -13, 10), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, major, kMinor);
    for (int i = 0; i < 100; ++i) {
      const double u = 0.37 * i, v = 0.3 + 0.008 * i;  // clear of the pole, where the sheets meet
      const SurfaceJet jet = torus->evaluate({u, v}, 1);
      const Vec3 way = (jet.du.cross(jet.dv).normalized() + 0.4 * jet.du.normalized()).normalized();
      std::vector<SurfaceRoot> roots;
      torus->intersect(jet.p - 3.0 * way, jet.p + 2.0 * way, roots);
      ASSERT_EQ(roots.size(), 2u) << major << " " << i;
      EXPECT_LE(roots[0].t, roots[1].t);
      int outer = 0;
      for (const SurfaceRoot& root : roots) {
        EXPECT_FALSE(root.tangent);
        EXPECT_NEAR((torus->evaluate(root.uv, 0).p - (jet.p + (5.0 * root.t - 3.0) * way)).norm(), 0.0,
                    1e-12);
        outer += std::cos(root.uv.y()) > -major / kMinor;
      }
      EXPECT_EQ(outer, 1) << "one root is on the outer sheet, one on the inner";
    }
  }
}

}  // namespace
}  // namespace octet
