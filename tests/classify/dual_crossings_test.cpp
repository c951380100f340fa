// SPDX-License-Identifier: BSD-3-Clause
// Dual segments: a facet that stands for one sheet is left alone, one that stands for more is told.
#include "classify/dual_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geom/analytic.h"

namespace octet {
namespace {

constexpr double kRadius = 0.9;  // of the facet's circumcircle, about (-1, 0, 0)

/// The place of an apex on the x axis that puts the circumcentre at (centre, 0, 0); `side` 1: towards +x.
double apex_for(double centre, double side) { return centre + side * std::hypot(centre + 1.0, kRadius); }

/// Two tetrahedra at an equilateral facet on the face x = -1 of a box [-1,1]^3 with a void of radius 0.2 in
/// its middle. The inner one's circumcentre is given, the outer one's lies outside the box.
struct TwoTets {
  explicit TwoTets(double inner_centre) {
    const int face = model.closest(Vec3(-1, 0, 0), 0.1)->face;
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 3.0;
      mesh.points.push_back(Vec3(-1.0, kRadius * std::cos(angle), kRadius * std::sin(angle)));
      on.push_back(model_face(face));
    }
    mesh.points.push_back(Vec3(apex_for(inner_centre, 1.0), 0, 0));
    on.push_back(model_region(1));
    mesh.points.push_back(Vec3(apex_for(-1.3, -1.0), 0, 0));
    on.push_back(model_region(0));
    const VertexId a(0), b(1), c(2), p(3), q(4);
    mesh.tets.push_back({a, b, c, p});  // the facet is its face 3
    mesh.tets.push_back({a, c, b, q});
    mesh.tets.push_back({a, b, c, kGhostVertex});
    const TetId inner(0), outer(1), ghost(2);
    mesh.neighbours.push_back({ghost, ghost, ghost, outer});
    mesh.neighbours.push_back({ghost, ghost, ghost, inner});
    mesh.neighbours.push_back({inner, outer, inner, outer});
    const TetId all[] = {inner, outer, ghost};
    band.update(mesh, on, all);
  }

  Model model = analytic_box_minus_ball(2.0, 0.2);
  Band band{model, [this](const Vec3& x) { return model.region_at(x); }};
  TetMesh mesh;
  std::vector<ModelRef> on;
};

TEST(DualCrossings, ASegmentThatMeetsItsFaceOnceIsNoGap) {
  TwoTets pair(-0.5);
  EXPECT_TRUE(find_dual_crossings(pair.band, pair.mesh, pair.on).empty());
}

TEST(DualCrossings, ASegmentThroughAVoidIsAGap) {
  TwoTets pair(0.5);
  const std::vector<Gap> gaps = find_dual_crossings(pair.band, pair.mesh, pair.on);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].kind, GapKind::kDualCrossing);
  EXPECT_EQ(gaps[0].entity, pair.on[0]);
  EXPECT_LT((gaps[0].place - Vec3(-1, 0, 0)).norm(), 1e-12);
  // The point that would close it lies on the void, on its far side: the apexes stand for boundary points.
  const std::vector<ModelRef> boundary(pair.mesh.points.size(), pair.on[0]);
  const auto point = facet_point(pair.model, pair.mesh, boundary, gaps[0].tet, gaps[0].local, 1e-6);
  ASSERT_TRUE(point.has_value());
  EXPECT_NEAR(point->point.x(), 0.2, 1e-9);
}

TEST(DualCrossings, ATetrahedronThatLiesElsewhereThanItsCircumcentreTellsNothing) {
  TwoTets pair(0.1);  // in the void, while its apex is in the material
  ASSERT_EQ(pair.band.region(TetId(0)), 1);
  EXPECT_TRUE(find_dual_crossings(pair.band, pair.mesh, pair.on).empty());
}

TEST(DualCrossings, AGhostHasNoCircumcentreAndItsEndLiesOnTheFacetsAxis) {
  TwoTets pair(-0.5);
  const DualSegment whole = dual_segment(pair.mesh, TetId(0), 3);
  EXPECT_TRUE(whole.exact);
  EXPECT_LT((whole.inner - Vec3(-0.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((whole.outer - Vec3(-1.3, 0, 0)).norm(), 1e-12);
  EXPECT_FALSE(dual_segment(pair.mesh, TetId(0), 0).exact);
}

}  // namespace
}  // namespace octet
