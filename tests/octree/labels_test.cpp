// SPDX-License-Identifier: BSD-3-Clause
#include "octree/labels.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <set>

#include "octree/octant_edges.h"
#include "tests/octree/labelled_models.h"

namespace octet {
namespace {

using test::analytic_models;
using test::label;
using test::Labelled;

TEST(OctreeLabels, EqualTheModelsAnswerAtEveryVertex) {
  for (const auto& [name, model, size] : analytic_models()) {
    const Labelled l = label(model, size, {{model.box().lo, 0.3 * size}, {model.box().centre(), 0.5 * size}});
    EXPECT_TRUE(l.labels.conflicts.empty()) << name;
    std::set<int> regions;
    for (std::size_t v = 0; v < l.vertices.size(); ++v) {
      const Vec3 p = l.tree.position(l.vertices.at[v]);
      if (model.closest(p, 1e-9).has_value()) continue;
      ASSERT_EQ(l.labels.vertex_region[v], model.region_at(p)) << name;
      regions.insert(l.labels.vertex_region[v]);
    }
    EXPECT_EQ(regions.size(), static_cast<std::size_t>(model.count(3)) + 1) << name;
  }
}

TEST(OctreeLabels, EndsOfAnEdgeWithoutACutHaveTheSameRegion) {
  for (const auto& [name, model, size] : analytic_models()) {
    const Labelled l = label(model, size);
    std::set<std::pair<std::uint32_t, std::uint32_t>> cut;
    for (const OctantEdgeCut& c : l.cuts) cut.insert({c.from, c.to});
    for (const OctantEdge& e : boundary_octant_edges(l.tree, l.vertices, l.types)) {
      if (cut.contains({e.from, e.to})) continue;
      EXPECT_EQ(l.labels.vertex_region[e.from], l.labels.vertex_region[e.to]) << name;
    }
  }
}

TEST(OctreeLabels, CornersOfInsideOctantsAreInTheirRegion) {
  const Model model = analytic_two_boxes(Vec3(0.7, 0.8, 0.9), test::turned());
  const Labelled l = label(model, 0.1);
  std::set<int> regions;
  for (std::size_t i = 0; i < l.tree.size(); ++i) {
    if (l.labels.type[i] == OctantType::kBoundary) continue;
    regions.insert(l.labels.region[i]);
    for (const std::uint32_t v : l.vertices.corners[i])
      EXPECT_EQ(l.labels.vertex_region[v], l.labels.region[i]);
  }
  EXPECT_EQ(regions, (std::set<int>{0, 1, 2}));
}

TEST(OctreeLabels, ACutThatIsMissingIsTold) {
  const Model model = analytic_ball(0.5);
  Labelled l = label(model, 0.1);
  // Without its cut this edge claims that both its ends lie on one side.
  const std::size_t middle = l.cuts.size() / 2;
  const OctantEdgeCut lost = l.cuts[middle];
  l.cuts.erase(l.cuts.begin() + static_cast<std::ptrdiff_t>(middle));
  const OctreeLabels labels = label_vertices(model, l.tree, l.vertices, l.types, l.edges, l.cuts);
  ASSERT_FALSE(labels.conflicts.empty());
  EXPECT_EQ(labels.conflicts.front().entity, model_face(1));
  EXPECT_LT((labels.conflicts.front().place - lost.hit.point).norm(), 0.3);
  EXPECT_FALSE(labels.conflicts.front().cause.empty());
  EXPECT_FALSE(labels.conflicts.front().advice.empty());
  // Told, and settled by the model all the same.
  EXPECT_EQ(labels.vertex_region[lost.from], model.region_at(l.tree.position(l.vertices.at[lost.from])));
  EXPECT_EQ(labels.vertex_region[lost.to], model.region_at(l.tree.position(l.vertices.at[lost.to])));
}

TEST(OctreeLabels, ACutTurnedRoundIsTold) {
  const Model model = analytic_box(Vec3(1.0, 1.2, 0.8), test::turned());
  Labelled l = label(model, 0.1);
  l.cuts[7].hit.normal = -l.cuts[7].hit.normal;
  const OctreeLabels labels = label_vertices(model, l.tree, l.vertices, l.types, l.edges, l.cuts);
  ASSERT_EQ(labels.conflicts.size(), 1u);
  EXPECT_EQ(labels.conflicts.front().entity, l.cuts[7].hit.on);
  EXPECT_EQ(labels.conflicts.front().place, l.cuts[7].hit.point);
  EXPECT_EQ(labels.vertex_region, l.labels.vertex_region);
}

TEST(OctreeLabels, EventsThatSayNothingAboutParityAreNotAsked) {
  const Model model = analytic_box(Vec3(1.0, 1.2, 0.8), test::turned());
  Labelled l = label(model, 0.1);
  for (std::size_t i = 0; i < l.cuts.size(); i += 3) l.cuts[i].hit.kind = HitKind::kTangent;
  for (std::size_t i = 1; i < l.cuts.size(); i += 3) l.cuts[i].hit.end_point = true;
  const OctreeLabels labels = label_vertices(model, l.tree, l.vertices, l.types, l.edges, l.cuts);
  EXPECT_TRUE(labels.conflicts.empty());
  EXPECT_EQ(labels.vertex_region, l.labels.vertex_region);
}

TEST(OctreeLabels, SurviveAModelThatLiesOnOctantPlanes) {
  // The tree of another box, of the same size but elsewhere, puts octant planes on this one's faces.
  const Model model = analytic_box(Vec3(1.0, 1.0, 1.0));
  std::vector<Octant> octants;
  for (MortonKey key = 0; key < MortonKey{1} << 12; ++key) octants.push_back(octant_of(key, 4));
  const Octree tree(Vec3::Constant(-0.5), 2.0, octants);
  const OctreeVertices vertices = octree_vertices(tree);
  const OctantTypes types = octant_types(model, tree);
  const std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, types);
  const auto cuts = cut_octant_edges(model, tree, vertices, edges);
  const OctreeLabels labels = label_vertices(model, tree, vertices, types, edges, cuts);
  EXPECT_TRUE(labels.conflicts.empty());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Vec3 p = tree.position(vertices.at[v]);
    const double depth = std::min(p.minCoeff(), (Vec3::Ones() - p).minCoeff());
    if (depth == 0.0) continue;
    EXPECT_EQ(labels.vertex_region[v], depth > 0.0 ? 1 : 0);
  }
}

TEST(OctreeLabels, DoNotDependOnTheNumberOfThreads) {
  const Model model = analytic_box_minus_ball(1.0, 0.35, test::turned());
  const auto regions = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return label(model, 0.07).labels.vertex_region;
  };
  EXPECT_EQ(regions(1), regions(2));
}

}  // namespace
}  // namespace octet
