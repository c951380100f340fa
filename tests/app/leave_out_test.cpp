// SPDX-License-Identifier: BSD-3-Clause
// A region that cannot be closed is left out; the mesh of the others is whole.
#include "app/leave_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "app/mesh_part.h"
#include "classify/acceptance.h"
#include "geom/analytic.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

Mesh mesh_of(const Model& model) {
  MeshOptions options;
  options.size = 0.25;
  options.threads = 1;
  return mesh_part(model, options).mesh;
}

TEST(LeaveOut, TheOtherRegionKeepsItsMeshAndItsSharedFace) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1));
  Mesh mesh = mesh_of(model);
  const Mesh whole = mesh;
  leave_out(mesh, model, {2});
  EXPECT_TRUE(check_mesh_soundness(mesh).empty());
  EXPECT_LT(mesh.points.size(), whole.points.size());
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& t = mesh.tets[i];
    EXPECT_EQ(mesh.tet_in[i], 1);
    volume += signed_volume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
  }
  EXPECT_NEAR(volume, 1.0, 1e-12);
  // All that lies on the entities of the first box is still there.
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& region = model.face(f).region;
    const bool own = region[0] == 1 || region[1] == 1;
    const auto on_face = [f](const Mesh& m) {
      return std::count(m.triangle_on.begin(), m.triangle_on.end(), f);
    };
    EXPECT_EQ(on_face(mesh), own ? on_face(whole) : 0) << "face " << f;
  }
  for (int e = 1; e <= model.count(1); ++e) {
    bool own = false;
    for (const int f : model.edge(e).faces)
      own = own || model.face(f).region[0] == 1 || model.face(f).region[1] == 1;
    const auto on_edge = [e](const Mesh& m) { return std::count(m.edge_on.begin(), m.edge_on.end(), e); };
    EXPECT_EQ(on_edge(mesh), own ? on_edge(whole) : 0) << "edge " << e;
  }
}

/// Where gaps are, all tetrahedra around a piece of an edge may have gone with the broken region.
TEST(LeaveOut, EdgesThatNoTetrahedronHasGoToo) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1));
  Mesh mesh = mesh_of(model);
  const auto is_of = [](const std::array<Mesh::Index, 2>& edge, const std::array<Mesh::Index, 4>& tet) {
    return std::all_of(edge.begin(), edge.end(),
                       [&](Mesh::Index v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); });
  };
  const auto in_region_1 = [&](const std::array<Mesh::Index, 2>& edge) {
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (is_of(edge, mesh.tets[t]) && mesh.tet_in[t] != 1) return false;
    return true;
  };
  const auto bare = *std::find_if(mesh.edges.begin(), mesh.edges.end(), in_region_1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (is_of(bare, mesh.tets[t])) mesh.tet_in[t] = 2;
  leave_out(mesh, model, {2});
  ASSERT_FALSE(mesh.edges.empty());
  for (const auto& edge : mesh.edges)
    EXPECT_TRUE(std::any_of(mesh.tets.begin(), mesh.tets.end(),
                            [&](const std::array<Mesh::Index, 4>& tet) { return is_of(edge, tet); }));
}

/// An attempt of which only the gaps are asked.
struct Gapped {
  explicit Gapped(const Model& model) : attempt(tree_of(model)) {}
  static Octree tree_of(const Model& model) {
    OctreeRequest request;
    request.size = 0.5;
    return build_octree(model, request, {});
  }
  void add(ModelRef entity) {
    Gap gap;
    gap.entity = entity;
    attempt.closed.gaps.push_back(gap);
  }
  Attempt attempt;
};

TEST(LeaveOut, AGapBreaksTheRegionsOfItsEntityOnly) {
  const Model model = analytic_two_boxes(Vec3(1, 1, 1));
  int own = 0, shared = 0;
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& region = model.face(f).region;
    if (region[0] + region[1] == 2) own = f;
    if (region[0] + region[1] == 3) shared = f;
  }
  Gapped gapped(model);
  EXPECT_TRUE(broken_regions(gapped.attempt, model).empty());
  gapped.add(model_face(own));
  EXPECT_EQ(broken_regions(gapped.attempt, model), std::vector<int>{2});
  const std::vector<Fault> faults = describe_left_out(gapped.attempt, model, {2});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].entity, model_region(2));
  gapped.add(model_face(shared));
  EXPECT_TRUE(broken_regions(gapped.attempt, model).empty()) << "nothing is left to save";
}

}  // namespace
}  // namespace octet
