// SPDX-License-Identifier: BSD-3-Clause
// Queries of whole models against the formulas of their shapes.
#include "geom/model.h"

#include <gtest/gtest.h>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::all_samples;
using test::Dice;
using test::Sample;

std::vector<Sample> samples_in_both_frames() {
  std::vector<Sample> samples = all_samples();
  for (Sample& s : all_samples(test::tilted_frame())) samples.push_back(std::move(s));
  return samples;
}

TEST(Model, RegionAgreesWithTheFormulaAtRandomPoints) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(1);
    const Box3 box = s.model.box().grown(0.2);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p = dice.in(box);
      const double depth = s.depth(p);
      if (std::abs(depth) < 1e-9) continue;
      ASSERT_EQ(s.model.region_at(p), depth > 0 ? 1 : 0) << s.name << " depth " << depth;
    }
  }
}

TEST(Model, RegionIsRightCloseToTheBoundaryOnBothSides) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(2);
    int near = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto foot = s.model.closest(dice.in(s.model.box()), 1e9);
      ASSERT_TRUE(foot.has_value());
      for (const double d : {1e-3, 1e-5, 1e-8}) {
        for (const double side : {-d, d}) {
          const Vec3 p = foot->point + side * foot->normal;
          const double depth = s.depth(p);
          if (std::abs(depth) < 0.1 * d) continue;  // at an edge the normal of one face may run along another
          ASSERT_EQ(s.model.region_at(p), depth > 0 ? 1 : 0) << s.name << " depth " << depth << " d " << d;
          ++near;
        }
      }
    }
    EXPECT_GT(near, 6000) << s.name;
  }
}

TEST(Model, ClosestPointHasTheDistanceOfTheFormulaInside) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(3);
    for (int i = 0; i < 1500; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const double depth = s.depth(p);
      if (depth <= 0.0) continue;
      const auto foot = s.model.closest(p, 1e9);
      ASSERT_TRUE(foot.has_value());
      ASSERT_NEAR(foot->distance, depth, 1e-10) << s.name;
      ASSERT_NEAR((foot->point - p).norm(), foot->distance, 1e-12);
      ASSERT_NEAR(s.depth(foot->point), 0.0, 1e-10) << s.name;
    }
  }
}

TEST(Model, ClosestPointIsNoFartherThanAnyBoundarySample) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(4);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = dice.in(s.model.box().grown(1.0));
      const auto foot = s.model.closest(p, 1e9);
      ASSERT_TRUE(foot.has_value());
      double sampled = 1e9;
      for (const Vec3& n : s.model.facets().nodes) sampled = std::min(sampled, (n - p).norm());
      ASSERT_LE(foot->distance, sampled + 1e-10) << s.name;
      ASSERT_FALSE(s.model.closest(p, 0.999 * foot->distance).has_value()) << s.name;
    }
  }
}

TEST(Model, SegmentsCrossAsOftenAsTheRegionChanges) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(5);
    int crossings = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = dice.in(s.model.box().grown(0.3)), q = dice.in(s.model.box().grown(0.3));
      if (std::abs(s.depth(p)) < 1e-6 || std::abs(s.depth(q)) < 1e-6) continue;
      std::vector<Hit> hits;
      s.model.intersect(p, q, hits);
      int region = s.model.region_at(p);
      for (const Hit& hit : hits) {
        ASSERT_NEAR(s.depth(hit.point), 0.0, 1e-9) << s.name;
        ASSERT_NEAR((p + hit.t * (q - p) - hit.point).norm(), 0.0, 1e-9);
        ASSERT_EQ(hit.kind, HitKind::kTransversal);
        const auto& sides = s.model.face(hit.face).region;
        const int into = hit.normal.dot(q - p) > 0 ? sides[1] : sides[0];
        ASSERT_NE(into, region) << s.name;
        region = into;
        ++crossings;
      }
      ASSERT_EQ(region, s.depth(q) > 0 ? 1 : 0) << s.name;
    }
    EXPECT_GT(crossings, 500) << s.name;
  }
}

TEST(Model, NoCrossingIsMissedAlongASegmentSampledDensely) {
  for (const Sample& s : all_samples(test::tilted_frame())) {
    Dice dice(6);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = dice.in(s.model.box()), q = dice.in(s.model.box());
      std::vector<Hit> hits;
      s.model.intersect(p, q, hits);
      std::size_t changes = 0;
      constexpr int kSteps = 2000;
      for (int k = 0; k < kSteps; ++k) {
        const double a = s.depth(p + (q - p) * k / kSteps), b = s.depth(p + (q - p) * (k + 1) / kSteps);
        if ((a > 0) != (b > 0)) ++changes;
      }
      ASSERT_GE(hits.size(), changes) << s.name;
      ASSERT_EQ((hits.size() - changes) % 2, 0u) << s.name;
    }
  }
}

TEST(Model, BothRegionsOfTwoBoxesAreToldApart) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1), {test::tilted_frame(), 1e-2});
  const Frame f = test::tilted_frame();
  Dice dice(7);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 l = dice.vec(Vec3::Constant(-0.5), Vec3(2.5, 1.5, 1.5));
    const bool in = l.y() > 0 && l.y() < 1 && l.z() > 0 && l.z() < 1 && l.x() > 0 && l.x() < 2;
    ASSERT_EQ(model.region_at(f.origin + f.axes * l), in ? (l.x() < 1 ? 1 : 2) : 0);
  }
}

TEST(Model, AcuteCornersAreSeenFromOutside) {
  // Beyond an acute corner the face with the largest |n.(p - x)| has the wrong sign for some p.
  const double angle = 0.15;
  const Model wedge = analytic_wedge(angle, 1.0, 1.0);
  Dice dice(9);
  const auto inside = [&](const Vec3& p) {
    const Vec3 a(1, 0, 0), b(std::cos(angle), std::sin(angle), 0);
    const Vec3 far((b - a).y(), -(b - a).x(), 0), up(-std::sin(angle), std::cos(angle), 0);
    return p.y() > 0 && up.dot(p) < 0 && far.dot(p - a) < 0 && p.z() > 0 && p.z() < 1;
  };
  for (int v = 1; v <= 6; ++v)
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = wedge.vertex(v).point + dice(1e-6, 0.4) * dice.direction();
      ASSERT_EQ(wedge.region_at(p), inside(p) ? 1 : 0) << p.transpose();
    }
}

TEST(Model, SegmentThroughAnEdgeIsOneEventOfThatEdge) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  std::vector<Hit> hits;
  box.intersect(Vec3(-0.5, -0.5, 0.4), Vec3(0.5, 0.5, 0.4), hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].on.dim, 1);
  EXPECT_EQ(hits[0].kind, HitKind::kTransversal);
  EXPECT_NEAR(hits[0].t, 0.5, 1e-12);
  hits.clear();
  box.intersect(Vec3(-0.5, 0.5, 0.4), Vec3(0.5, -0.5, 0.4), hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].on.dim, 1);
  EXPECT_EQ(hits[0].kind, HitKind::kTangent);
}

TEST(Model, SegmentThroughAVertexIsOneEventOfThatVertex) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  std::vector<Hit> hits;
  box.intersect(Vec3(-0.5, -0.5, -0.5), Vec3(1.5, 1.5, 1.5), hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].on.dim, 0);
  EXPECT_EQ(hits[1].on.dim, 0);
  EXPECT_EQ(hits[0].kind, HitKind::kTransversal);
}

TEST(Model, SegmentInAFaceIsCoincidentThere) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  std::vector<Hit> hits;
  box.intersect(Vec3(0.25, 0.5, 1), Vec3(0.75, 0.5, 1), hits);
  ASSERT_EQ(hits.size(), 2u);
  for (const Hit& h : hits) {
    EXPECT_EQ(h.kind, HitKind::kCoincident);
    EXPECT_TRUE(h.end_point);
  }
  hits.clear();
  box.intersect(Vec3(-0.5, 0.5, 1), Vec3(1.5, 0.5, 1), hits);
  ASSERT_EQ(hits.size(), 2u);
  for (const Hit& h : hits) {
    EXPECT_EQ(h.on.dim, 1);
    EXPECT_EQ(h.kind, HitKind::kCoincident);
  }
  EXPECT_NEAR(hits[0].t, 0.25, 1e-12);
  EXPECT_NEAR(hits[1].t, 0.75, 1e-12);
  hits.clear();
  box.intersect(Vec3(-0.5, 0.5, 1 + 1e-6), Vec3(1.5, 0.5, 1 + 1e-6), hits);
  EXPECT_TRUE(hits.empty());
  box.intersect(Vec3(-0.5, 0.5, 1 - 1e-6), Vec3(1.5, 0.5, 1 - 1e-6), hits);
  EXPECT_EQ(hits.size(), 2u);
}

TEST(Model, SegmentAlongAnEdgeReportsItsEnds) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  std::vector<Hit> hits;
  box.intersect(Vec3(0.25, 0, 0), Vec3(0.75, 0, 0), hits);
  ASSERT_EQ(hits.size(), 2u);
  for (const Hit& h : hits) {
    EXPECT_EQ(h.on.dim, 1);
    EXPECT_EQ(h.kind, HitKind::kCoincident);
  }
}

TEST(Model, SegmentThatEndsOnTheBoundarySaysSo) {
  for (const Sample& s : samples_in_both_frames()) {
    Dice dice(8);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const auto foot = s.model.closest(p, 1e9);
      if (foot->distance < 1e-3) continue;
      std::vector<Hit> hits;
      s.model.intersect(p, foot->point, hits);
      ASSERT_EQ(hits.size(), 1u) << s.name;
      ASSERT_TRUE(hits[0].end_point) << s.name;
      ASSERT_NEAR(hits[0].t, 1.0, 1e-6) << s.name;
    }
  }
}

TEST(Model, GrazingSegmentsKeepTheirTwoRoots) {
  const Model cylinder = analytic_cylinder(1.0, 2.0);
  for (const double d : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    std::vector<Hit> hits;
    cylinder.intersect(Vec3(-2, 1 - d, 1), Vec3(2, 1 - d, 1), hits);
    ASSERT_EQ(hits.size(), 2u) << d;
    EXPECT_NEAR(hits[1].point.x(), std::sqrt(d * (2 - d)), 1e-6 * std::sqrt(d));
  }
  std::vector<Hit> hits;
  cylinder.intersect(Vec3(-2, 1, 1), Vec3(2, 1, 1), hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].kind, HitKind::kTangent);
  hits.clear();
  cylinder.intersect(Vec3(-2, 1 + 1e-9, 1), Vec3(2, 1 + 1e-9, 1), hits);
  EXPECT_TRUE(hits.empty());
}

TEST(Model, ConeAxisIsInsideUpToTheApex) {
  const Model cone = analytic_cone(1.0, 1.0);
  for (const double d : {0.5, 1.0 / 32, 1e-2, 1e-3, 1e-4, 1e-6}) {
    EXPECT_EQ(cone.region_at(Vec3(0, 0, 1 - d)), 1) << d;
    EXPECT_EQ(cone.region_at(Vec3(0, 0, 1 + d)), 0) << d;
  }
  std::vector<Hit> hits;
  cone.intersect(Vec3(0, 0, 0.5), Vec3(0, 0, 1.5), hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].on.dim, 0);
}

TEST(Model, LineThroughThePolesOfABallHitsThemOnce) {
  const Model ball = analytic_ball(1.0);
  std::vector<Hit> hits;
  ball.intersect(Vec3(0, 0, -2), Vec3(0, 0, 2), hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].point.z(), -1.0, 1e-14);
  EXPECT_NEAR(hits[1].point.z(), 1.0, 1e-14);
  hits.clear();
  ball.intersect(Vec3(0, 0, 0), Vec3(2, 0, 0), hits);  // the seam
  EXPECT_EQ(hits.size(), 1u);
}

TEST(Model, EdgesMeasureTheirLengthBothWays) {
  for (const Sample& s : samples_in_both_frames()) {
    for (int e = 1; e <= s.model.count(1); ++e) {
      const ModelEdge& edge = s.model.edge(e);
      if (edge.use == EdgeUse::kDegenerate) continue;
      EXPECT_NEAR(s.model.edge_length(e, edge.t0, edge.t1), edge.length, 1e-10 * edge.length);
      const double middle = s.model.edge_parameter(e, edge.t0, 0.5 * edge.length);
      EXPECT_NEAR(s.model.edge_length(e, edge.t0, middle), 0.5 * edge.length, 1e-10 * edge.length);
      EXPECT_NEAR(s.model.edge_length(e, middle, edge.t0), -0.5 * edge.length, 1e-10 * edge.length);
      EXPECT_EQ(s.model.edge_parameter(e, edge.t0, 2.0 * edge.length), edge.t1);
      EXPECT_EQ(s.model.edge_parameter(e, edge.t1, -2.0 * edge.length), edge.t0);
      const Vec3 p = s.model.edge_point(e, edge.t0 + 0.3 * (edge.t1 - edge.t0));
      EXPECT_LT(s.model.edge_closest(e, p).distance, 1e-12 * s.model.diagonal());
    }
  }
}

TEST(Model, CurvatureIsThatOfTheShape) {
  const Model ball = analytic_ball(2.0), cylinder = analytic_cylinder(0.5, 1.0),
              box = analytic_box(Vec3(1, 1, 1));
  EXPECT_NEAR(ball.face_curvature(1, Vec2(1.0, 0.3)), 0.5, 1e-12);
  EXPECT_NEAR(cylinder.face_curvature(1, Vec2(1.0, 0.3)), 2.0, 1e-12);
  EXPECT_EQ(box.face_curvature(1, Vec2(0.2, 0.3)), 0.0);
}

TEST(Model, ClosureFollowsTheAdjacency) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1));
  int shared = 0, vertices_of_first = 0;
  for (int f = 1; f <= model.count(2); ++f)
    shared +=
        model.in_closure(model_face(f), model_region(1)) && model.in_closure(model_face(f), model_region(2));
  for (int v = 1; v <= model.count(0); ++v)
    vertices_of_first += model.in_closure(model_vertex(v), model_region(1));
  EXPECT_EQ(shared, 1);
  EXPECT_EQ(vertices_of_first, 8);
  EXPECT_FALSE(model.in_closure(model_region(1), model_region(2)));
  EXPECT_EQ(model.describe(model_face(3)), "Face 3");
}

TEST(Model, BoxesFarFromTheBoundaryAreNotNearIt) {
  const Model ball = analytic_ball(1.0);
  Box3 middle, across, away;
  middle.add(Vec3::Constant(-0.5));
  middle.add(Vec3::Constant(0.5));
  across.add(Vec3(0.9, -0.1, -0.1));
  across.add(Vec3(1.1, 0.1, 0.1));
  away.add(Vec3(2, 2, 2));
  away.add(Vec3(3, 3, 3));
  EXPECT_FALSE(ball.near_boundary(middle));
  EXPECT_TRUE(ball.near_boundary(across));
  EXPECT_FALSE(ball.near_boundary(away));
}

}  // namespace
}  // namespace octet
