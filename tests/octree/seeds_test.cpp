// SPDX-License-Identifier: BSD-3-Clause
// The first point set: where points lie, how far apart they are, and that thin sheets get matched pairs and
// columns.
#include "octree/seeds.h"

#include <gtest/gtest.h>

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "geom/analytic.h"
#include "octree/even_walls.h"
#include "octree/seed_state.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

struct Stage {
  Octree tree;
  OctreeVertices vertices;
  OctreeLabels labels;
  std::vector<OctantEdgeCut> cuts;
  Seeds seeds;
};

Stage seed(const Model& model, double size) {
  OctreeRequest request;
  request.size = size;
  Octree tree = build_octree(model, request, {});
  OctreeVertices vertices = octree_vertices(tree);
  const OctantTypes types = octant_types(model, tree);
  const std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, types);
  std::vector<OctantEdgeCut> cuts = cut_octant_edges(model, tree, vertices, edges);
  OctreeLabels labels = label_vertices(model, tree, vertices, types, edges, cuts);
  Seeds seeds = test::seed_points(model, tree, vertices, labels, cuts, {size});
  return {std::move(tree), std::move(vertices), std::move(labels), std::move(cuts), std::move(seeds)};
}

Frame oblique() {
  Frame frame;
  frame.origin = Vec3(0.3, -0.2, 0.7);
  frame.axes = (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))
                   .toRotationMatrix();
  return frame;
}

TEST(Seeds, EveryModelVertexIsAPoint) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1), {oblique(), 1e-3});
  const Stage stage = seed(model, 0.3);
  for (int v = 1; v <= model.count(0); ++v) {
    const std::uint32_t n = stage.seeds.model_vertex[v];
    EXPECT_EQ(stage.seeds.points.on[n], model_vertex(v));
    EXPECT_EQ((stage.seeds.points.position[n] - model.vertex(v).point).norm(), 0.0);
  }
}

TEST(Seeds, EveryRealEdgeIsOneChainInTheOrderOfItsParameter) {
  const Model model = analytic_cylinder(1.0, 2.0, {oblique(), 1e-3});
  const Stage stage = seed(model, 0.3);
  std::vector<const EdgePiece*> last(static_cast<std::size_t>(model.count(1)) + 1, nullptr);
  for (const EdgePiece& piece : stage.seeds.pieces) {
    const ModelEdge& edge = model.edge(piece.edge);
    ASSERT_EQ(edge.use, EdgeUse::kReal);
    EXPECT_LT(piece.ta, piece.tb);
    if (last[piece.edge] == nullptr) {
      EXPECT_EQ(piece.a, stage.seeds.model_vertex[edge.vertex[0]]);
      EXPECT_EQ(piece.ta, edge.t0);
    } else {
      EXPECT_EQ(piece.a, last[piece.edge]->b);
      EXPECT_EQ(piece.ta, last[piece.edge]->tb);
    }
    last[piece.edge] = &piece;
  }
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    ASSERT_EQ(last[e] != nullptr, edge.use == EdgeUse::kReal);
    if (last[e] == nullptr) continue;
    EXPECT_EQ(last[e]->b, stage.seeds.model_vertex[edge.vertex[1]]);
    EXPECT_EQ(last[e]->tb, edge.t1);
  }
}

TEST(Seeds, PointsLieOnTheirEntities) {
  const Model model = analytic_torus(2.0, 0.6, {oblique(), 1e-3});
  const Stage stage = seed(model, 0.3);
  ASSERT_GT(stage.seeds.surface_points, 50u);
  for (std::size_t n = 0; n < stage.seeds.surface_points; ++n) {
    const auto foot = model.closest(stage.seeds.points.position[n], 1.0);
    ASSERT_TRUE(foot.has_value());
    EXPECT_LT(foot->distance, 1e-11);
  }
}

/// Of each point on a face the distance to the nearest other of its closure, in spacings of octants of
/// `size`, in ascending order.
std::vector<double> distances_on_faces(const Model& model, double size) {
  const Stage stage = seed(model, size);
  const SeedPoints& points = stage.seeds.points;
  std::vector<double> distances;
  for (std::size_t i = 0; i < stage.seeds.surface_points; ++i) {
    if (points.on[i].dim != 2) continue;
    distances.push_back(10.0);
    for (std::size_t j = 0; j < stage.seeds.surface_points; ++j)
      if (i != j && model.in_closure(points.on[j], points.on[i]))
        distances.back() = std::min(
            distances.back(), (points.position[i] - points.position[j]).norm() / (kSpacingPerOctant * size));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(Seeds, FacePointsKeepTheirDistanceFromTheClosureOfTheirFace) {
  const auto on_planes = distances_on_faces(analytic_box(Vec3(1, 1.3, 0.9), {oblique(), 1e-3}), 0.2);
  EXPECT_GT(on_planes.front(), 0.8 * (1 - 1e-6));
  EXPECT_LT(on_planes.front(), 0.9);
  const auto on_a_ball = distances_on_faces(analytic_ball(1.0, {oblique(), 1e-3}), 0.25);
  EXPECT_GT(on_a_ball.front(), 0.7 * (1 - 1e-6));
  EXPECT_LT(on_a_ball.front(), 0.8) << "chords of curved faces are shorter";
}

TEST(Seeds, PointsOnPlanesStandWiderWhereThereIsRoom) {
  for (const Frame& frame : {Frame(), oblique()}) {
    const auto thick = distances_on_faces(analytic_box(Vec3(1, 1.3, 0.9), {frame, 1e-3}), 0.1);
    EXPECT_GT(thick[thick.size() / 4], 0.95 * (1 - 1e-6));
    const auto thin = distances_on_faces(analytic_box(Vec3(1, 1.3, 0.15), {frame, 1e-3}), 0.1);
    EXPECT_LT(thin[thin.size() / 4], 0.95) << "one or two layers of elements";
  }
}

TEST(Seeds, BlocksOfManyCutsKeepOneAnothersDistance) {
  const Model model = analytic_ball(1.0, {oblique(), 1e-3});
  const double size = 0.02;
  const Stage stage = seed(model, size);
  ASSERT_GT(stage.cuts.size(), kCutsInBlocks);
  const double spacing = kSpacingPerOctant * size;
  PointGrid grid(stage.tree.origin(), stage.tree.root_size());
  const SeedPoints& points = stage.seeds.points;
  for (std::uint32_t n = 0; n < stage.seeds.surface_points; ++n) {
    EXPECT_FALSE(grid.any_within(points.position[n], 0.7 * (1 - 1e-6) * spacing,
                                 [](std::uint32_t, double) { return true; }));
    grid.add(n, points.position[n], spacing);
  }
  // Nor is there room for another, at the seams of blocks as elsewhere.
  std::size_t places = 0;
  for (const OctantEdgeCut& cut : stage.cuts) {
    if (cut.hit.on.dim != 2) continue;
    ++places;
    EXPECT_TRUE(grid.any_within(cut.hit.point, spacing, [](std::uint32_t, double) { return true; }));
  }
  EXPECT_GT(places, kCutsInBlocks);
}

/// A part that has cuts in blocks gets the same points with one thread as with all.
void expect_same_points(const Model& model, double size) {
  const auto places = [&] {
    const Stage stage = seed(model, size);
    EXPECT_GT(stage.cuts.size(), kCutsInBlocks);
    return stage.seeds.points.position;
  };
  std::vector<Vec3> alone;
  tbb::task_arena(1).execute([&] { alone = places(); });
  EXPECT_EQ(places(), alone);
}

TEST(Seeds, BlocksOfManyCutsAreTheSameForAnyNumberOfThreads) {
  expect_same_points(analytic_box(Vec3(1, 1, 0.004), {oblique(), 1e-3}), 0.008);
}

TEST(Seeds, StacksOfManyCutsAreTheSameForAnyNumberOfThreads) {
  expect_same_points(analytic_two_boxes(Vec3(0.006, 1, 1), {oblique(), 1e-3}), 0.01);
}

/// Of octree points in a region, how near the nearest is to the surface, in local sizes; 1 where none is
/// nearer.
double nearest_octree_point(const Model& model, const Stage& stage, int region = 1) {
  double nearest = 1.0;
  const SeedPoints& points = stage.seeds.points;
  for (std::size_t n = stage.seeds.surface_points; n < points.size(); ++n) {
    EXPECT_EQ(points.on[n].dim, 3);
    if (points.on[n].tag != region) continue;
    if (const auto foot = model.closest(points.position[n], points.spacing[n]))
      nearest = std::min(nearest, foot->distance / points.spacing[n]);
  }
  return nearest;
}

TEST(Seeds, OctreeVerticesKeepTheirDistanceFromTheSurface) {
  const Model model = analytic_ball(1.0, {oblique(), 1e-3});
  const Stage stage = seed(model, 0.25);
  EXPECT_GT(std::count_if(stage.seeds.points.on.begin(), stage.seeds.points.on.end(),
                          [](ModelRef on) { return on == model_region(1); }),
            50);
  EXPECT_GE(nearest_octree_point(model, stage), 0.55 * (1 - 1e-9));
}

TEST(Seeds, OctreeVerticesStandNearerToTheFacesOfWalls) {
  // Plates in which the lattice's layers come as near as 0.4 to a face, but not within 0.55 of it, at some
  // thickness; in all they may, for both faces are near.
  double nearest = 1.0;
  for (const double thickness : {0.22, 0.24, 0.26, 0.28, 0.30, 0.32}) {
    const Model model = analytic_box(Vec3(1, 1.1, thickness), {oblique(), 1e-3});
    nearest = std::min(nearest, nearest_octree_point(model, seed(model, 0.2)));
  }
  EXPECT_GE(nearest, 0.4 * (1 - 1e-9));
  EXPECT_LT(nearest, 0.5);
}

TEST(Seeds, OctreeVerticesInVoidsKeepTheirDistanceFromTheSurface) {
  double nearest = 1.0;
  for (const double inner : {0.25, 0.28, 0.31, 0.34, 0.37, 0.4}) {
    const Model model = analytic_hollow_ball(1.0, inner, {oblique(), 1e-3});
    nearest = std::min(nearest, nearest_octree_point(model, seed(model, 0.25), 0));
  }
  EXPECT_GE(nearest, 0.55 * (1 - 1e-9));
  EXPECT_LT(nearest, 1.0);
}

TEST(Seeds, NoOctreeVertexStandsInAThinWall) {
  std::size_t in_thin = 0, in_thick = 0;
  for (const double thickness : {0.15, 0.16, 0.17, 0.18, 0.19, 0.21, 0.22, 0.23, 0.24, 0.25}) {
    const Model model = analytic_box(Vec3(1, 1.1, thickness), {oblique(), 1e-3});
    const Stage stage = seed(model, 0.2);
    const auto& on = stage.seeds.points.on;
    const auto inside = static_cast<std::size_t>(std::count(on.begin(), on.end(), model_region(1)));
    const double spacing = stage.tree.spacing_at(model.box().centre());
    (thickness < kThinWall * spacing ? in_thin : in_thick) += inside;
  }
  EXPECT_EQ(in_thin, 0u);
  EXPECT_GT(in_thick, 10u);
}

TEST(Seeds, NoOctreeVertexStandsWhereTheCadDoesNotKnowItsSide) {
  ModelParts parts = analytic_box(Vec3(1, 1, 1), {oblique(), 1e-3}).parts();
  parts.edges[1].tolerance = 0.11;
  const Model model(std::move(parts));
  const Stage stage = seed(model, 0.1);
  const auto corridor = [&](const Vec3& p) { return model.edge_closest(1, p).distance; };
  double nearest = 1.0;
  std::size_t vague = 0;
  for (std::size_t v = 0; v < stage.vertices.size(); ++v) {
    const double distance = corridor(stage.tree.position(stage.vertices.at[v]));
    vague += distance < 0.22;
    if (stage.seeds.octree_vertex_kept[v]) nearest = std::min(nearest, distance);
  }
  EXPECT_GT(vague, 50u);
  EXPECT_GE(nearest, 0.22);
}

TEST(Seeds, AThinPlateGetsEveryPointTwiceStraightAcross) {
  const double thickness = 0.02;
  const Model model = analytic_box(Vec3(1, 1, thickness), {});
  const Stage stage = seed(model, 0.2);
  const SeedPoints& points = stage.seeds.points;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < stage.seeds.surface_points; ++i) {
    const Vec3 p = points.position[i];
    if (std::abs(p.z()) > 1e-12 || p.x() <= 0.0 || p.x() >= 1.0 || p.y() <= 0.0 || p.y() >= 1.0) continue;
    std::size_t partners = 0;
    for (std::size_t j = 0; j < stage.seeds.surface_points; ++j)
      partners += (points.position[j] - Vec3(p.x(), p.y(), thickness)).norm() < 1e-9;
    EXPECT_EQ(partners, 1u) << p.transpose();
    ++pairs;
  }
  EXPECT_GT(pairs, 10u);
}

/// Of two layers side by side, each point within a face has points straight across on the two other sheets.
void expect_columns(double thickness, double size, std::size_t least_cuts) {
  const Model model = analytic_two_boxes(Vec3(thickness, 1, 1), {oblique(), 1e-3});
  const Stage stage = seed(model, size);
  EXPECT_GE(stage.cuts.size(), least_cuts);
  const SeedPoints& points = stage.seeds.points;
  const double spacing = kSpacingPerOctant * size;
  PointGrid grid(stage.tree.origin(), stage.tree.root_size());
  for (std::uint32_t n = 0; n < stage.seeds.surface_points; ++n) grid.add(n, points.position[n], spacing);
  const Frame frame = oblique();
  std::size_t columns = 0, alone = 0;
  for (std::uint32_t n = 0; n < stage.seeds.surface_points; ++n) {
    const Vec3 local = frame.axes.transpose() * (points.position[n] - frame.origin);
    if (points.on[n].dim != 2 || local.y() < 1e-9 || local.y() > 1 - 1e-9 || local.z() < 1e-9 ||
        local.z() > 1 - 1e-9)
      continue;
    ++columns;
    for (const double x : {0.0, thickness, 2.0 * thickness}) {
      const Vec3 across = frame.origin + frame.axes * Vec3(x, local.y(), local.z());
      if (!grid.any_within(across, 1e-9, [](std::uint32_t, double) { return true; })) ++alone;
    }
  }
  EXPECT_GT(columns, 30u);
  EXPECT_EQ(alone, 0u) << "of " << columns << " at " << thickness;
}

TEST(Seeds, AStackOfThinLayersGetsItsPointsInColumns) {
  expect_columns(0.02, 0.2, 0);
  expect_columns(0.15, 0.2, 0);  // farther than single sheets are matched
}

TEST(Seeds, AStackOfThinLayersGetsItsPointsInColumnsInBlocksToo) {
  expect_columns(0.002, 0.01, kCutsInBlocks);
  expect_columns(0.006, 0.01, kCutsInBlocks);  // farther than partners in blocks
}

TEST(Seeds, EdgesOfAKnifeGetPointsAtEqualDistanceFromTheirCommonVertex) {
  const Model model = analytic_wedge(0.17, 1.0, 1.0, {});
  const Stage stage = seed(model, 0.2);
  const SeedPoints& points = stage.seeds.points;
  // In the plane z = 0 two edges leave the knife's vertex at 10 degrees.
  std::vector<double> along_x, along_leg;
  for (std::size_t n = 0; n < stage.seeds.surface_points; ++n) {
    const Vec3 p = points.position[n];
    if (points.on[n].dim != 1 || std::abs(p.z()) > 1e-12) continue;
    if (p.norm() < 0.9) (std::abs(p.y()) < 1e-12 ? along_x : along_leg).push_back(p.norm());
  }
  std::sort(along_x.begin(), along_x.end());
  std::sort(along_leg.begin(), along_leg.end());
  ASSERT_GE(along_x.size(), 3u);
  ASSERT_EQ(along_x.size(), along_leg.size());
  for (std::size_t i = 0; i < along_x.size(); ++i) EXPECT_NEAR(along_x[i], along_leg[i], 1e-9);
}

}  // namespace
}  // namespace octet
