// SPDX-License-Identifier: BSD-3-Clause
#include "app/interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/mesh_part.h"
#include "delaunay/triangulation.h"
#include "geom/analytic.h"
#include "mesh/quality.h"
#include "mesh/soundness.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

struct SplitBall {
  SplitBall() {
    const double size = 0.04;
    std::vector<SizeSample> samples;  // half the size in a cube off the centre
    for (int n = 0; n < 1000; ++n) samples.push_back({0.02 * Vec3(n % 10, n / 10 % 10, n / 100), 0.5 * size});
    tree = build_octree(model, {size}, samples);
    vertices = octree_vertices(tree);
    const OctantTypes types = octant_types(model, tree);
    const std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, types);
    const std::vector<OctantEdgeCut> cuts = cut_octant_edges(model, tree, vertices, edges);
    labels = label_vertices(model, tree, vertices, types, edges, cuts);
    seeds = test::seed_points(model, tree, vertices, labels, cuts, {size});
    split = split_interior(model, tree, vertices, labels, seeds, size);
  }
  Model model = analytic_ball(0.5);
  Octree tree{Vec3::Zero(), 1.0, {Octant{}}};
  OctreeVertices vertices;
  OctreeLabels labels;
  Seeds seeds;
  BandAndInterior split;
};

TEST(Interior, WithItsTemplatesTheBallIsTheOneTriangulationOfAllItsPoints) {
  // Every tetrahedron of the whole triangulation that lies in the region is in the mesh before finalization.
  const SplitBall s;
  Triangulation all;
  all.insert_all(s.seeds.points.position, s.seeds.points.order);
  const TetMesh& whole = all.mesh();
  using Corners = std::array<std::array<double, 3>, 4>;
  const auto corners_of = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Corners corners;
    int n = 0;
    for (const Vec3* p : {&a, &b, &c, &d}) corners[n++] = {p->x(), p->y(), p->z()};
    std::ranges::sort(corners);
    return corners;
  };
  std::set<Corners> expected;
  for (std::size_t i = 0; i < whole.tets.size(); ++i) {
    if (!whole.alive(TetId(i)) || whole.tets[TetId(i)][3] == kGhostVertex) continue;
    const auto& v = whole.tets[TetId(i)];
    expected.insert(
        corners_of(whole.points[v[0]], whole.points[v[1]], whole.points[v[2]], whole.points[v[3]]));
  }
  std::vector<Vec3> points = s.split.band.position;
  std::vector<ModelRef> on = s.split.band.on;
  const ExtraTets near = near_tets(s.tree, s.vertices, s.labels, s.split, points, on);
  for (const auto& t : near.tets)
    EXPECT_TRUE(expected.contains(corners_of(points[t[0]], points[t[1]], points[t[2]], points[t[3]])));
  Mesh mesh;
  for (const std::uint32_t p : near.first) mesh.points.push_back(points[p]);
  mesh.point_on.assign(mesh.points.size(), model_region(1));
  append_deep(s.tree, s.vertices, s.labels, s.split, mesh);
  EXPECT_GT(mesh.tets.size(), 1000u);
  for (const auto& t : mesh.tets)
    EXPECT_TRUE(expected.contains(
        corners_of(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]])));
  // The band's triangulation has all the others.
  Triangulation band;
  band.insert_all(s.split.band.position, s.split.band.order);
  const TetMesh& rest = band.mesh();
  std::size_t kept = 0, total = expected.size();
  for (std::size_t i = 0; i < rest.tets.size(); ++i) {
    if (!rest.alive(TetId(i)) || rest.tets[TetId(i)][3] == kGhostVertex) continue;
    const auto& v = rest.tets[TetId(i)];
    const std::array<Vec3, 4> p{rest.points[v[0]], rest.points[v[1]], rest.points[v[2]], rest.points[v[3]]};
    if (near.covers(0.25 * (p[0] + p[1] + p[2] + p[3]))) continue;
    EXPECT_TRUE(expected.contains(corners_of(p[0], p[1], p[2], p[3])));
    ++kept;
  }
  EXPECT_EQ(kept + near.tets.size() + mesh.tets.size(), total);
}

TEST(Interior, BandNearAndDeepMakeOneSoundMeshFinalizedOrNot) {
  for (const bool finalize : {false, true}) {
    MeshOptions options;
    options.size = 0.05;
    options.finalize = finalize;
    const MeshResult result = mesh_part(analytic_ball(0.5), options);
    EXPECT_EQ(check_mesh_soundness(result.mesh), "");
    EXPECT_EQ(result.report.status, MeshStatus::kComplete);
    EXPECT_GT(result.report.template_tets, result.report.tets / 10);
  }
}

TEST(Interior, DeepVolumesAndBandFillTheBall) {
  const SplitBall s;
  const std::vector<double> volume = deep_volumes(s.tree, s.labels, s.split, 1);
  Mesh mesh;
  std::vector<Vec3> points = s.split.band.position;
  std::vector<ModelRef> on = s.split.band.on;
  const ExtraTets near = near_tets(s.tree, s.vertices, s.labels, s.split, points, on);
  for (const std::uint32_t p : near.first) mesh.points.push_back(points[p]);
  mesh.point_on.assign(mesh.points.size(), model_region(1));
  append_deep(s.tree, s.vertices, s.labels, s.split, mesh);
  double sum = 0.0;
  for (const auto& t : mesh.tets)
    sum += signed_volume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
  EXPECT_NEAR(sum, volume[1], 1e-12);
  EXPECT_LT(volume[1], s.model.region(1).volume);
  EXPECT_GT(volume[1], 0.3 * s.model.region(1).volume);
}

}  // namespace
}  // namespace octet
