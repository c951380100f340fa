// SPDX-License-Identifier: BSD-3-Clause
// The facet hierarchy against brute force.
#include "geom/facet_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

TEST(FacetBvh, NearestIsTheNearestOfAllTriangles) {
  for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
    const Facets& f = s.model.facets();
    Dice dice(1);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = dice.in(s.model.box().grown(0.5));
      for (int face = 0; face <= s.model.count(2); ++face) {
        double best = 1e9;
        for (std::size_t t = 0; t < f.triangles.size(); ++t) {
          if (face != 0 && f.face[t] != face) continue;
          const auto& n = f.triangles[t];
          best = std::min(best, closest_on_triangle(p, f.nodes[n[0]], f.nodes[n[1]], f.nodes[n[2]]).distance);
        }
        const auto near = s.model.bvh().nearest(p, 1e9, face);
        ASSERT_TRUE(near.has_value());
        ASSERT_NEAR(near->distance, best, 1e-12) << s.name;
        ASSERT_FALSE(s.model.bvh().nearest(p, 0.999 * best, face).has_value());
      }
    }
  }
}

TEST(FacetBvh, VisitWithinFindsAllThatAreNear) {
  for (const auto& s : test::all_samples({}, 0.05)) {
    const Facets& f = s.model.facets();
    Dice dice(2);
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const double radius = dice(0.0, 1.0);
      std::set<std::uint32_t> found, expected;
      s.model.bvh().visit_within(p, radius, 0, [&](const FacetFoot& foot) { found.insert(foot.triangle); });
      for (std::uint32_t t = 0; t < f.triangles.size(); ++t) {
        const auto& n = f.triangles[t];
        const double d = closest_on_triangle(p, f.nodes[n[0]], f.nodes[n[1]], f.nodes[n[2]]).distance;
        if (d <= radius + s.model.bvh().grow(t)) expected.insert(t);
      }
      ASSERT_EQ(found, expected) << s.name;
    }
  }
}

TEST(FacetBvh, VisitSegmentLeavesOneFaceOut) {
  for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
    Dice dice(3);
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = dice.in(s.model.box()), q = dice.in(s.model.box());
      const int but = 1 + i % s.model.count(2);
      std::set<std::uint32_t> found, expected;
      const auto face_of = [&](std::uint32_t t) { return s.model.facets().face[t]; };
      s.model.bvh().visit_segment(p, q, [&](std::uint32_t t) {
        if (face_of(t) != but) expected.insert(t);
      });
      s.model.bvh().visit_segment(
          p, q, [&](std::uint32_t t) { found.insert(t); }, but);
      ASSERT_EQ(found, expected) << s.name;
    }
  }
}

TEST(FacetBvh, NearGivesJustThoseThatMayHoldTheNearestPoint) {
  for (const auto& s : test::all_samples({}, 0.05)) {
    const Facets& f = s.model.facets();
    const FacetBvh& bvh = s.model.bvh();
    Dice dice(7);
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const double limit = (i % 2 == 0 ? 1.0 : 0.02) * s.model.diagonal();
      std::vector<double> distance;
      double reach = limit;
      for (std::uint32_t t = 0; t < f.triangles.size(); ++t) {
        const auto& n = f.triangles[t];
        distance.push_back(closest_on_triangle(p, f.nodes[n[0]], f.nodes[n[1]], f.nodes[n[2]]).distance);
        reach = std::min(reach, distance.back() + bvh.grow(t));
      }
      std::set<std::uint32_t> expected, found;
      for (std::uint32_t t = 0; t < distance.size(); ++t)
        if (distance[t] <= reach + bvh.grow(t)) expected.insert(t);
      std::vector<FacetFoot> feet;
      bvh.near(p, limit, 0, feet);
      for (const FacetFoot& foot : feet) found.insert(foot.triangle);
      ASSERT_EQ(found, expected) << s.name;
      ASSERT_EQ(found.size(), feet.size());
    }
  }
}

TEST(FacetBvh, SegmentVisitsEveryTriangleThatItPierces) {
  for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
    const Facets& f = s.model.facets();
    Dice dice(3);
    int pierced = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = dice.in(s.model.box());
      Vec3 q = dice.in(s.model.box());
      for (int k = 0; k < 3 && i % 2 == 0; ++k)
        if (k != i / 2 % 3) q[k] = p[k];  // along an axis
      std::set<std::uint32_t> visited;
      s.model.bvh().visit_segment(p, q, [&](std::uint32_t t) { visited.insert(t); });
      for (std::uint32_t t = 0; t < f.triangles.size(); ++t) {
        const auto& n = f.triangles[t];
        const Vec3 &a = f.nodes[n[0]], &b = f.nodes[n[1]], &c = f.nodes[n[2]];
        const Vec3 normal = (b - a).cross(c - a);
        const double hp = normal.dot(p - a), hq = normal.dot(q - a);
        if (hp * hq >= 0.0) continue;
        const Vec3 x = p + hp / (hp - hq) * (q - p);
        if (closest_on_triangle(x, a, b, c).distance > 1e-12) continue;
        ASSERT_TRUE(visited.count(t)) << s.name;
        ++pierced;
      }
    }
    EXPECT_GT(pierced, 50) << s.name;
  }
}

TEST(FacetBvh, SegmentVisitsNoTriangleThatItPassesBeside) {
  // Two long thin triangles, one in the other's box; the segment pierces the plane of both, but one triangle.
  Facets facets;
  facets.nodes = {{0, 0, 0}, {10, 9, 0}, {10, 10, 0}, {10, 10.5, 0}, {0, 0.5, 0}};
  facets.triangles = {{0, 1, 2}, {2, 3, 4}};
  facets.face = {1, 1};
  const double grow = 0.01;
  const FacetBvh bvh(facets, std::vector<double>(2, grow), 1);
  const auto visited = [&](const Vec3& p, const Vec3& q) {
    std::set<std::uint32_t> triangles;
    bvh.visit_segment(p, q, [&](std::uint32_t t) { triangles.insert(t); });
    return triangles;
  };
  using Set = std::set<std::uint32_t>;
  for (const Vec3& d : {Vec3(0, 0, 1), Vec3(0.1, -0.2, 1)}) {
    EXPECT_EQ(visited(Vec3(8, 7.6, 0) - d, Vec3(8, 7.6, 0) + d), Set{0});
    EXPECT_EQ(visited(Vec3(8, 8.3, 0) - d, Vec3(8, 8.3, 0) + d), Set{1});
    EXPECT_EQ(visited(Vec3(8, 7.1, 0) - d, Vec3(8, 7.1, 0) + d), Set{});
    EXPECT_EQ(visited(Vec3(8, 7.2 - 0.9 * grow, 0) - d, Vec3(8, 7.2 - 0.9 * grow, 0) + d), Set{0});
  }
}

/// A grid of 80 000 triangles on a wavy sheet, on two faces: more than one task builds.
Facets wavy_sheet() {
  constexpr std::uint32_t kSide = 200;
  Facets f;
  for (std::uint32_t j = 0; j <= kSide; ++j)
    for (std::uint32_t i = 0; i <= kSide; ++i) f.nodes.emplace_back(i, j, 5.0 * std::sin(0.1 * i + 0.07 * j));
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const std::uint32_t a = j * (kSide + 1) + i, b = a + 1, c = b + kSide, d = c + 1;
      f.triangles.push_back({a, b, d});
      f.triangles.push_back({a, d, c});
      f.face.insert(f.face.end(), 2, i % 3 == 0 ? 1 : 2);
    }
  return f;
}

TEST(FacetBvh, OfManyTrianglesIsBuiltAlikeByOneAndByManyThreads) {
  const Facets f = wavy_sheet();
  const std::vector<double> grow(f.triangles.size(), 0.01);
  const FacetBvh bvh(f, grow, 2, FacetBvh::Building::kManyThreads);
  const auto order_of = [&f](const FacetBvh& tree) {
    std::vector<std::uint32_t> order;
    tree.visit_within(Vec3(100, 100, 0), 1e3, 0,
                      [&](const FacetFoot& foot) { order.push_back(foot.triangle); });
    EXPECT_EQ(order.size(), f.triangles.size());
    return order;
  };
  EXPECT_EQ(order_of(FacetBvh(f, grow, 2)), order_of(bvh));
  Dice dice(7);
  for (int n = 0; n < 30; ++n) {
    const Vec3 p(dice(-20.0, 220.0), dice(-20.0, 220.0), dice(-20.0, 20.0));
    for (const int face : {0, 1, 2}) {
      double best = 1e9;
      for (std::size_t t = 0; t < f.triangles.size(); ++t) {
        const auto& v = f.triangles[t];
        if (face == 0 || f.face[t] == face)
          best = std::min(best, closest_on_triangle(p, f.nodes[v[0]], f.nodes[v[1]], f.nodes[v[2]]).distance);
      }
      const auto near = bvh.nearest(p, 1e9, face);
      ASSERT_TRUE(near.has_value());
      ASSERT_NEAR(near->distance, best, 1e-12);
    }
  }
}

TEST(FacetBvh, DegenerateTrianglesAreSegments) {
  const Vec3 a(0, 0, 0), b(2, 0, 0);
  const FacetFoot foot = closest_on_triangle(Vec3(0.5, 1, 0), a, b, b);
  EXPECT_NEAR(foot.distance, 1.0, 1e-15);
  EXPECT_LT((foot.point - Vec3(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(closest_on_triangle(Vec3(3, 0, 0), a, b, b).distance, 1.0, 1e-15);
}

}  // namespace
}  // namespace octet
