// SPDX-License-Identifier: BSD-3-Clause
#include "app/interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/mesh_part.h"
#include "delaunay/templates.h"
#include "geom/analytic.h"
#include "mesh/quality.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

using Corners = std::set<std::array<double, 3>>;

Corners corners_of(const Mesh& mesh, std::size_t tet) {
  Corners corners;
  for (const Mesh::Index v : mesh.tets[tet])
    corners.insert({mesh.points[v].x(), mesh.points[v].y(), mesh.points[v].z()});
  return corners;
}

struct SplitBall {
  SplitBall() {
    const double size = 0.04;
    std::vector<SizeSample> samples;  // half the size in a cube off the centre
    for (int n = 0; n < 1000; ++n) samples.push_back({0.02 * Vec3(n % 10, n / 10 % 10, n / 100), 0.5 * size});
    tree = build_octree(model, {size}, samples);
    vertices = octree_vertices(tree);
    const OctantTypes types = octant_types(model, tree);
    const std::vector<OctantEdgeCut> cuts = cut_octant_edges(model, tree, vertices, types);
    labels = label_vertices(model, tree, vertices, types, cuts);
    const Seeds seeds = seed_points(model, tree, vertices, labels, cuts, size);
    split = split_interior(model, tree, vertices, labels, seeds, size);
  }
  Model model = analytic_ball(0.5);
  Octree tree{Vec3::Zero(), 1.0, {Octant{}}};
  OctreeVertices vertices;
  OctreeLabels labels;
  BandAndInterior split;
};

TEST(Interior, DeepOctantsGetTheTetrahedraThatTheTemplateTableGivesThem) {
  const SplitBall s;
  std::vector<Vec3> points = s.split.band.position;
  std::vector<ModelRef> on = s.split.band.on;
  const ExtraTets near = near_tets(s.tree, s.vertices, s.labels, s.split, points, on);
  Mesh mesh;
  for (const std::uint32_t p : near.first) mesh.points.push_back(points[p]);
  mesh.point_on.assign(mesh.points.size(), model_region(1));
  const std::size_t appended = append_deep(s.tree, s.vertices, s.labels, s.split, mesh);
  ASSERT_EQ(appended, mesh.tets.size());
  TemplateTable table;
  std::size_t at = 0, deep = 0;
  std::set<int> levels;
  for (std::size_t o = 0; o < s.tree.size(); ++o) {
    if (s.split.role[o] != OctantRole::kDeep) continue;
    ++deep;
    levels.insert(s.tree[OctantId(o)].level);
    const OctantLattice lattice = octant_lattice(s.tree, s.vertices, OctantId(o));
    OctantPattern pattern;
    for (const std::uint8_t p : kHangingPoint) ASSERT_EQ(lattice[p], kNoVertex);
    for (const std::uint8_t p : kCornerPoint) pattern.rank[p] = s.vertices.rank(lattice[p]);
    std::set<Corners> expected, found;
    for (const auto& t : table.tets(pattern)) {
      Corners corners;
      for (const std::uint8_t p : t) {
        const Vec3 x = s.tree.position(s.vertices.at[lattice[p]]);
        corners.insert({x.x(), x.y(), x.z()});
      }
      expected.insert(corners);
    }
    for (std::size_t k = 0; k < expected.size(); ++k) found.insert(corners_of(mesh, at++));
    ASSERT_EQ(found, expected);
  }
  EXPECT_EQ(at, appended);
  EXPECT_GT(deep, 1000u);
  EXPECT_GE(levels.size(), 2u);
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
