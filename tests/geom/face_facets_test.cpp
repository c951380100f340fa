// SPDX-License-Identifier: BSD-3-Clause
// Facets of a face close on its boundary, whatever the loops do, and follow its surface.
#include "geom/face_facets.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "geom/facet_bvh.h"
#include "geom/planar_triangulation.h"
#include "geom/quadrics.h"

namespace octet {
namespace {

using Loop = std::vector<std::uint32_t>;

/// Appends a loop through the given points.
void add_loop(FaceLoops& loops, const std::vector<Vec2>& points) {
  Loop loop;
  for (const Vec2& p : points) {
    loop.push_back(static_cast<std::uint32_t>(loops.uv.size()));
    loops.uv.push_back(p);
  }
  loops.loops.push_back(loop);
}

SurfaceJets jets_of(const Surface& surface) {
  return [&surface](const Vec2& uv, int derivatives) { return surface.evaluate(uv, derivatives); };
}

std::vector<Vec2> circle(const Vec2& centre, double radius, int n, int way = 1) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = way * 2.0 * kPi * i / n;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// Border sides once, in the loops' direction; all others as often in one direction as in the other.
void expect_closed(const FaceLoops& loops, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      EXPECT_NE(a, b);
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  for (const Loop& loop : loops.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      balance[std::minmax(a, b)] -= a < b ? 1 : -1;
    }
  for (const auto& [side, sum] : balance) EXPECT_EQ(sum, 0) << side.first << "-" << side.second;
}

double area_of(const PlanarTriangulation& plane, int& turned) {
  double twice = 0.0;
  turned = 0;
  for (const auto& t : plane.triangles) {
    const Vec2 p = plane.points[t.corner[1]] - plane.points[t.corner[0]],
               q = plane.points[t.corner[2]] - plane.points[t.corner[0]];
    twice += p.x() * q.y() - p.y() * q.x();
    turned += orient2d(plane.points[t.corner[0]], plane.points[t.corner[1]], plane.points[t.corner[2]]) <= 0;
  }
  return 0.5 * twice;
}

void expect_triangulated(const FaceLoops& loops, double area, bool all_positive) {
  const PlanarTriangulation plane = triangulate_loops(loops.uv, loops.loops);
  ASSERT_FALSE(plane.triangles.empty());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : plane.triangles) triangles.push_back(t.corner);
  expect_closed(loops, triangles);
  int turned = 0;
  EXPECT_NEAR(area_of(plane, turned), area, 1e-9 * std::abs(area));
  if (all_positive) {
    EXPECT_EQ(turned, 0);
  }
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(plane.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t u = plane.triangles[t].neighbour[k];
      if (u == PlanarTriangulation::kNone) continue;
      const auto& back = plane.triangles[u].neighbour;
      EXPECT_TRUE(back[0] == t || back[1] == t || back[2] == t);
    }
}

double polygon_area(double radius, int n) { return 0.5 * n * radius * radius * std::sin(2.0 * kPi / n); }

TEST(PlanarTriangulation, CoversACombOfManyTeeth) {
  FaceLoops loops;
  std::vector<Vec2> comb = {{0, 0}, {20, 0}};
  for (int i = 19; i >= 0; --i) {
    comb.push_back({i + 0.9, 5.0});
    comb.push_back({i + 0.5, 1.0});
    comb.push_back({i + 0.1, 5.0});
  }
  add_loop(loops, comb);
  double twice = 0.0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Vec2 &a = comb[i], &b = comb[(i + 1) % comb.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  expect_triangulated(loops, 0.5 * twice, true);
}

TEST(PlanarTriangulation, LeavesAHundredHolesOpen) {
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) add_loop(loops, circle({i + 0.5, j + 0.5}, 0.45, 12, -1));
  expect_triangulated(loops, 100.0 - 100.0 * polygon_area(0.45, 12), true);
}

/// The bridge from the square goes to the notch, past the round hole; that from the round hole must not cross
/// it on its way to the square.
TEST(PlanarTriangulation, BridgesOfHolesDoNotCross) {
  FaceLoops loops;
  add_loop(loops, {{4.4, -35}, {4.4, 35}, {-4.4, 35}, {-4.4, 0.43}, {-4.7, 0}, {-4.4, -0.43}, {-4.4, -35}});
  add_loop(loops, {{1.6, 12.4}, {1, 12.4}, {1, 13}, {1.6, 13}});
  add_loop(loops, circle({-2.83, 0}, 0.5, 8, -1));
  const double area = 8.8 * 70 + 0.3 * 0.43 - 0.36 - 4.0 * 0.25 * std::sin(kPi / 4.0);
  expect_triangulated(loops, area, true);
}

TEST(PlanarTriangulation, TakesAHoleThatTouchesItsOuterLoopInACorner) {
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  add_loop(loops, {{0, 0}, {1, 2}, {2, 1}});
  expect_triangulated(loops, 16.0 - 1.5, false);
}

/// A cylinder's face in (u,v), cut by another cylinder that touches it in a point of its seam.
TEST(PlanarTriangulation, HolesThatTouchBothSidesOfASeamAreNotCovered) {
  FaceLoops loops;
  const auto row = [](double from, double to, double v) {
    std::vector<Vec2> points;
    for (int i = 0; i < 32; ++i) points.push_back({from + i * (to - from) / 32, v});
    return points;
  };
  std::vector<Vec2> border = row(0.0, 6.0, 0.0);
  border.push_back({6.0, 0.0});
  border.push_back({6.0, 2.0});
  for (const Vec2& p : row(6.0, 0.0, 4.0)) border.push_back(p);
  border.push_back({0.0, 4.0});
  border.push_back({0.0, 2.0});
  add_loop(loops, border);
  const auto lens = [](double tip, double way) {
    std::vector<Vec2> points;
    for (int i = 0; i < 16; ++i) points.push_back({tip + way * i / 16, 2.0 + 0.5 * std::sin(kPi * i / 32)});
    for (int i = 16; i > 0; --i) points.push_back({tip + way * i / 16, 2.0 - 0.5 * std::sin(kPi * i / 32)});
    if (way < 0.0) std::reverse(points.begin() + 1, points.end());
    return points;
  };
  add_loop(loops, lens(0.0, 1.0));
  add_loop(loops, lens(6.0, -1.0));
  const PlanarTriangulation plane = triangulate_loops(loops.uv, loops.loops);
  double covered = 0.0;
  for (const auto& t : plane.triangles) {
    const Vec2 &a = plane.points[t.corner[0]], p = plane.points[t.corner[1]] - a,
               q = plane.points[t.corner[2]] - a;
    covered += 0.5 * std::abs(p.x() * q.y() - p.y() * q.x());
  }
  double holes = 0.0;
  for (int hole = 1; hole <= 2; ++hole)
    for (std::size_t i = 0; i < loops.loops[hole].size(); ++i) {
      const Vec2 &a = loops.uv[loops.loops[hole][i]],
                 &b = loops.uv[loops.loops[hole][(i + 1) % loops.loops[hole].size()]];
      holes += 0.5 * (a.y() * b.x() - a.x() * b.y());
    }
  EXPECT_GT(holes, 1.0);
  EXPECT_NEAR(covered, 24.0 - holes, 1e-9);
  expect_triangulated(loops, 24.0 - holes, false);
}

TEST(PlanarTriangulation, KeepsItsBorderWhereTheLoopCrossesItself) {
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {10, 0}, {10, 10}, {6, 10}, {4, -1}, {3.9, -1}, {2, 10}, {0, 10}});
  const PlanarTriangulation plane = triangulate_loops(loops.uv, loops.loops);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : plane.triangles) triangles.push_back(t.corner);
  ASSERT_EQ(triangles.size(), 6u);
  expect_closed(loops, triangles);
  EXPECT_EQ(loop_crossings(loops).size(), 2u);
}

TEST(PlanarTriangulation, KeepsItsBorderWhereAHoleCrossesIt) {
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add_loop(loops, circle({9.8, 5.0}, 0.5, 16, -1));
  const PlanarTriangulation plane = triangulate_loops(loops.uv, loops.loops);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : plane.triangles) triangles.push_back(t.corner);
  ASSERT_EQ(triangles.size(), 4u + 16u);
  expect_closed(loops, triangles);
}

TEST(PlanarTriangulation, RefusesLoopsWithNothingOnTheirLeft) {
  FaceLoops loops;
  add_loop(loops, circle({0, 0}, 1.0, 8, -1));
  EXPECT_TRUE(triangulate_loops(loops.uv, loops.loops).triangles.empty());
}

TEST(PlanarTriangulation, IsDelaunay) {
  FaceLoops loops;
  add_loop(loops, circle({0, 0}, 1.0, 40));
  PlanarTriangulation plane = triangulate_loops(loops.uv, loops.loops);
  for (int i = 0; i < 200; ++i)
    (void)plane.split_triangle(static_cast<std::int32_t>((i * 7919) % plane.triangles.size()));
  for (const auto& t : plane.triangles) {
    const Vec2 &a = plane.points[t.corner[0]], &b = plane.points[t.corner[1]], &c = plane.points[t.corner[2]];
    ASSERT_GT(orient2d(a, b, c), 0);
    for (int k = 0; k < 3; ++k) {
      const std::int32_t u = t.neighbour[k];
      if (u == PlanarTriangulation::kNone) continue;
      for (const std::uint32_t i : plane.triangles[u].corner) {
        const auto lift = [](const Vec2& p) { return Vec3(p.x(), p.y(), p.squaredNorm()); };
        const Vec3 n = (lift(b) - lift(a)).cross(lift(c) - lift(a));
        EXPECT_GE(n.dot(lift(plane.points[i]) - lift(a)), -1e-10);
      }
    }
  }
}

TEST(FaceFacets, FollowACylinderWithinTheDeflection) {
  const auto surface = make_cylinder(Axes3{}, 5.0);
  FaceLoops loops;
  std::vector<Vec2> border;
  constexpr int kSides = 24;
  for (int i = 0; i <= kSides; ++i) border.push_back({2.0 * kPi * i / kSides, 0.0});
  for (int i = kSides; i >= 0; --i) border.push_back({2.0 * kPi * i / kSides, 30.0});
  add_loop(loops, border);
  FacetLimits limits;
  limits.deflection = 0.05;
  const FaceFacets facets = facet_face(jets_of(*surface), false, loops, limits);
  ASSERT_FALSE(facets.triangles.empty());
  expect_closed(loops, facets.triangles);
  double area = 0.0;
  for (const auto& t : facets.triangles) {
    const Vec3 a = surface->evaluate(facets.uv[t[0]], 0).p, b = surface->evaluate(facets.uv[t[1]], 0).p,
               c = surface->evaluate(facets.uv[t[2]], 0).p;
    area += triangle_area(a, b, c);
    EXPECT_GT(((a + b + c) / 3.0).head<2>().norm(), 5.0 - 0.1);
  }
  EXPECT_NEAR(area, 2.0 * kPi * 5.0 * 30.0, 0.02 * 2.0 * kPi * 5.0 * 30.0);
}

TEST(FaceFacets, AWireGetsNoMoreOfThemForBeingLong) {
  const auto surface = make_cylinder(Axes3{}, 1.0);
  const auto facets_of = [&](double length) {
    FaceLoops loops;
    std::vector<Vec2> border;
    constexpr int kSides = 12;
    for (int i = 0; i <= kSides; ++i) border.push_back({2.0 * kPi * i / kSides, 0.0});
    for (int i = kSides; i >= 0; --i) border.push_back({2.0 * kPi * i / kSides, length});
    add_loop(loops, border);
    FacetLimits limits;
    limits.deflection = 0.05;
    const FaceFacets facets = facet_face(jets_of(*surface), false, loops, limits);
    expect_closed(loops, facets.triangles);
    for (const auto& t : facets.triangles) {
      Vec3 centre = Vec3::Zero();
      for (const std::uint32_t corner : t) centre += surface->evaluate(facets.uv[corner], 0).p / 3.0;
      EXPECT_GT(centre.head<2>().norm(), 1.0 - 0.1);
    }
    return facets.triangles.size();
  };
  const std::size_t of_short = facets_of(4.0 * kPi);
  EXPECT_GT(of_short, 20u);
  EXPECT_EQ(facets_of(1000.0), of_short);
}

TEST(FaceFacets, AThreadIsNotStraightForLookingTheSameAfterEachTurn) {
  constexpr double kInner = 1.0, kOuter = 1.3, kRise = 0.1;
  constexpr int kTurns = 5, kSides = 48 * kTurns;  // as many turns as there are samples along a face
  const SurfaceJets thread = [kRise](const Vec2& uv, int) {
    SurfaceJet jet;
    const Vec3 out(std::cos(uv.y()), std::sin(uv.y()), 0.0), along(-out.y(), out.x(), 0.0);
    jet.p = uv.x() * out + kRise * uv.y() * Vec3::UnitZ();
    jet.du = out;
    jet.dv = uv.x() * along + kRise * Vec3::UnitZ();
    return jet;
  };
  std::vector<Vec2> border;
  for (int i = 0; i <= kSides; ++i) border.emplace_back(kOuter, 2.0 * kPi * kTurns * i / kSides);
  for (int i = kSides; i >= 0; --i) border.emplace_back(kInner, 2.0 * kPi * kTurns * i / kSides);
  FaceLoops loops;
  add_loop(loops, border);
  const FaceFacets facets = facet_face(thread, false, loops, {.deflection = 0.003});
  EXPECT_GE(facets.triangles.size(), 2 * kSides);
  EXPECT_LE(facets.triangles.size(), 8 * kSides);
}

TEST(FaceFacets, PutPointsInsideASphereOfOneCoarseLoop) {
  const auto surface = make_sphere(Axes3{}, 1.0);
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {kPi / 2, 0}, {kPi, 0}, {kPi, 1.2}, {kPi / 2, 1.2}, {0, 1.2}});
  FacetLimits limits;
  limits.deflection = 0.002;
  const FaceFacets facets = facet_face(jets_of(*surface), false, loops, limits);
  expect_closed(loops, facets.triangles);
  EXPECT_GT(facets.inner.size(), 50u);
  for (const Vec3& p : facets.inner) EXPECT_NEAR(p.norm(), 1.0, 1e-12);
}

TEST(FaceFacets, SayHowFarOffTheyAreWhereThereIsNoRoomForMore) {
  const auto surface = make_sphere(Axes3{}, 1.0);
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {kPi / 2, 0}, {kPi, 0}, {kPi, 1.2}, {kPi / 2, 1.2}, {0, 1.2}});
  FacetLimits limits;
  limits.deflection = 0.002;
  EXPECT_EQ(facet_face(jets_of(*surface), false, loops, limits).off, 0.0);
  limits.max_points = 5;
  const FaceFacets few = facet_face(jets_of(*surface), false, loops, limits);
  EXPECT_EQ(few.inner.size(), 5u);
  double off = 0.0;
  for (const auto& t : few.triangles) {
    const Vec2 middle = (few.uv[t[0]] + few.uv[t[1]] + few.uv[t[2]]) / 3.0;
    const auto corner = [&](int k) { return surface->evaluate(few.uv[t[k]], 0).p; };
    off = std::max(
        off, closest_on_triangle(surface->evaluate(middle, 0).p, corner(0), corner(1), corner(2)).distance);
  }
  EXPECT_NEAR(few.off, off, 1e-12);
  EXPECT_GT(few.off, 10.0 * limits.deflection);
}

/// Sides of an edge that has the face on both of its sides, and of one that starts where it ends.
TEST(FaceFacets, SlitsInACurvedFaceDoNotFoldIt) {
  const auto surface = make_cylinder(Axes3{}, 1.0);
  FaceLoops loops;
  add_loop(loops, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {1, 2}, {0, 2}});
  const auto add_slit = [&](const auto& point) {
    constexpr int kSides = 12;
    std::vector<Vec2> there_and_back;
    for (int i = 0; i < 2 * kSides; ++i)
      there_and_back.push_back(point((i <= kSides ? i : 2 * kSides - i) / static_cast<double>(kSides)));
    add_loop(loops, there_and_back);
  };
  add_slit([](double s) { return Vec2(0.5 + s, 0.6 + 0.4 * std::sin(3 * s)); });
  add_slit([](double s) { return Vec2(1.5 + s, 0.6 + 0.4 * std::sin(3.0) + 0.5 * s * s); });
  add_slit([](double s) { return Vec2(1.5 + 0.2 * s, 0.6 + 0.4 * std::sin(3.0) - 0.5 * s); });
  FacetLimits limits;
  limits.deflection = 1e-3;
  const FaceFacets facets = facet_face(jets_of(*surface), false, loops, limits);
  expect_closed(loops, facets.triangles);
  EXPECT_LT(facets.triangles.size(), 8000u);
  double twice_area = 0.0;
  for (const auto& t : facets.triangles) {
    const Vec2 p = facets.uv[t[1]] - facets.uv[t[0]], q = facets.uv[t[2]] - facets.uv[t[0]];
    const double twice = p.x() * q.y() - p.y() * q.x();
    EXPECT_GT(twice, -1e-6);
    twice_area += twice;
  }
  EXPECT_NEAR(twice_area, 12.0, 1e-5);
}

}  // namespace
}  // namespace octet
