// SPDX-License-Identifier: BSD-3-Clause
#include "octree/cuts.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>

#include "base/error.h"
#include "octree/octant_edges.h"
#include "octree/seeds.h"
#include "tests/octree/labelled_models.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

using test::analytic_models;
using test::label;
using test::Labelled;

bool same(const OctantEdgeCut& a, const OctantEdgeCut& b) {
  return a.from == b.from && a.to == b.to && a.hit.t == b.hit.t && a.hit.point == b.hit.point &&
         a.hit.on == b.hit.on && a.hit.face == b.hit.face && a.hit.uv == b.hit.uv &&
         a.hit.normal == b.hit.normal && a.hit.kind == b.hit.kind && a.hit.end_point == b.hit.end_point;
}

TEST(OctantEdgeCuts, EqualTheModelsAnswerOnEveryEdgeOfTheTree) {
  for (const auto& [name, model, size] : analytic_models()) {
    const Labelled l = label(model, size, {{model.box().lo, 0.3 * size}, {model.box().centre(), 0.5 * size}});
    OctantTypes everywhere = l.types;  // edges off the boundary too: they must have no cut
    std::ranges::fill(everywhere.type, OctantType::kBoundary);
    std::vector<OctantEdgeCut> expected;
    for (const OctantEdge& e : boundary_octant_edges(l.tree, l.vertices, everywhere)) {
      std::vector<Hit> hits;
      model.intersect(l.tree.position(l.vertices.at[e.from]), l.tree.position(l.vertices.at[e.to]), hits);
      for (const Hit& hit : hits) expected.push_back({e.from, e.to, hit});
    }
    EXPECT_FALSE(expected.empty());
    ASSERT_EQ(l.cuts.size(), expected.size()) << name;
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_TRUE(same(l.cuts[i], expected[i])) << name;
  }
}

TEST(OctantEdgeCuts, TheSearchEndsWhenCancelled) {
  const Model model = analytic_box(Vec3(1.0, 1.0, 1.0));
  const Labelled l = label(model, 1.0 / 4);
  EXPECT_THROW((void)cut_octant_edges(model, l.tree, l.vertices, l.edges, [] { return true; }), Cancelled);
  SeedOptions never{1.0 / 4};
  never.cancelled = [] { return true; };
  EXPECT_THROW((void)test::seed_points(model, l.tree, l.vertices, l.labels, l.cuts, never), Cancelled);
}

TEST(OctantEdgeCuts, OfABoxLieOnItsPlanes) {
  const Model model = analytic_box(Vec3(1.0, 1.0, 1.0));
  const Labelled l = label(model, 1.0 / 16);
  const auto diagonals =
      static_cast<std::size_t>(std::ranges::count_if(l.cuts, [&](const OctantEdgeCut& cut) {
        return cut.from < l.vertices.corner_count() && cut.to >= l.vertices.corner_count();
      }));
  // One a line and side, of corners, and of centres where the octants outside are of the same level: the root
  // is shifted off the planes.
  EXPECT_GE(l.cuts.size() - diagonals, 6u * 16 * 16);
  EXPECT_LE(l.cuts.size() - diagonals, 2 * 6u * 16 * 16);
  // Four meet in each centre, but not all of those at the sides lie on the box.
  EXPECT_GT(diagonals, 6u * 15 * 15 * 4);
  EXPECT_LT(diagonals, 6u * 17 * 17 * 4);
  for (const OctantEdgeCut& cut : l.cuts) {
    EXPECT_EQ(cut.hit.kind, HitKind::kTransversal);
    EXPECT_EQ(cut.hit.on, model_face(cut.hit.face));
    const auto& p = cut.hit.point;
    EXPECT_LT(std::min(p.cwiseAbs().minCoeff(), (p - Vec3::Ones()).cwiseAbs().minCoeff()), 1e-12);
  }
}

TEST(OctantEdgeCuts, DoNotDependOnTheNumberOfThreads) {
  const Model model = analytic_torus(0.7, 0.2, test::turned());
  const auto cuts = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return label(model, 0.05).cuts;
  };
  const auto one = cuts(1), two = cuts(2);
  EXPECT_GT(one.size(), 1000u);
  EXPECT_TRUE(std::ranges::equal(one, two, same));
}

}  // namespace
}  // namespace octet
