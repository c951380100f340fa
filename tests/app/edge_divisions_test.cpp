// SPDX-License-Identifier: BSD-3-Clause
// Numbers of elements on edges.
#include "app/edge_divisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/mesh_part.h"
#include "classify/acceptance.h"
#include "finalize/surplus.h"
#include "geom/analytic.h"

namespace octet {
namespace {

MeshResult mesh_with(const Model& model, double size, const std::vector<std::string>& wishes) {
  MeshOptions options;
  options.size = size;
  for (const std::string& wish : wishes) options.attributes.push_back(parse_size_attribute(wish));
  return mesh_part(model, options);
}

/// Lengths of the mesh edges on a model edge, ascending.
std::vector<double> pieces(const Mesh& mesh, int edge) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    if (mesh.edge_on[i] == edge)
      lengths.push_back((mesh.points[mesh.edges[i][1]] - mesh.points[mesh.edges[i][0]]).norm());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

void expect_equal_pieces(const MeshResult& result, int edge, std::size_t count) {
  const std::vector<double> lengths = pieces(result.mesh, edge);
  ASSERT_EQ(lengths.size(), count) << "Edge" << edge;
  EXPECT_LT(lengths.back(), 1.001 * lengths.front()) << "Edge" << edge;
}

TEST(EdgeDivisions, StraightEdgesGetJustSoManyEqualPieces) {
  const Model box = analytic_box(Vec3(10.0, 20.0, 30.0));
  for (const int count : {10, 11, 12, 17, 24, 33}) {
    const std::string number = std::to_string(count);
    const MeshResult result = mesh_with(box, 3.0, {"Edge1=/" + number, "Edge6=/" + number});
    EXPECT_EQ(result.report.status, MeshStatus::kComplete) << count;
    EXPECT_TRUE(result.report.notes.empty()) << result.report.notes.front();
    expect_equal_pieces(result, 1, static_cast<std::size_t>(count));
    expect_equal_pieces(result, 6, static_cast<std::size_t>(count));
  }
}

TEST(EdgeDivisions, ClosedEdgesToo) {
  const Model cylinder = analytic_cylinder(5.0, 10.0, {{}, 1e-3});
  for (int edge = 1; edge <= cylinder.count(1); ++edge) {
    if (cylinder.edge(edge).use != EdgeUse::kReal) continue;
    const MeshResult result = mesh_with(cylinder, 2.0, {"Edge" + std::to_string(edge) + "=/25"});
    EXPECT_EQ(result.report.status, MeshStatus::kComplete);
    expect_equal_pieces(result, edge, 25);
  }
}

TEST(EdgeDivisions, TheLargestNumberCounts) {
  const MeshResult result =
      mesh_with(analytic_box(Vec3(10.0, 10.0, 10.0)), 1.5, {"Edge3=/9", "Edge1-4=/13", "Edge3=/10"});
  for (const int edge : {1, 2, 3, 4}) expect_equal_pieces(result, edge, 13);
}

TEST(EdgeDivisions, SmallerSizesAboutAnEdgePrevailAndAreTold) {
  const MeshResult result = mesh_with(analytic_box(Vec3(10.0, 10.0, 10.0)), 1.0, {"Edge1=/3"});
  EXPECT_EQ(result.report.status, MeshStatus::kComplete);
  EXPECT_GT(pieces(result.mesh, 1).size(), 6u);
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes.front().find("Edge1 has "), std::string::npos) << result.report.notes.front();
  EXPECT_NE(result.report.notes.front().find("(3)"), std::string::npos) << result.report.notes.front();
}

TEST(EdgeDivisions, VerticesAreHeldWhereTheNumberIsMetAlone) {
  const Model box = analytic_box(Vec3(10.0, 20.0, 30.0));
  const Mesh mesh = mesh_with(box, 3.0, {"Edge1=/20"}).mesh;
  const auto held = [&](const char* wish) {
    return with_divided({}, mesh, edge_divisions(box, {parse_size_attribute(wish)}));
  };
  EXPECT_EQ(held("Edge1=/20").size(), 19u);
  EXPECT_TRUE(held("Edge1=/19").empty());
  EXPECT_EQ(with_divided({0, 1}, mesh, {}), (std::vector<Mesh::Index>{0, 1}));
}

/// Every second of twenty pieces' ends is one of ten's, and the others are too many.
TEST(EdgeDivisions, PointsBesidesAreDrawnOntoTheirNeighbours) {
  const Model box = analytic_box(Vec3(10.0, 20.0, 30.0));
  MeshOptions options;
  options.size = 3.0;
  options.finalize = false;
  options.attributes = {parse_size_attribute("Edge1=/20")};
  Mesh mesh = mesh_part(box, options).mesh;
  ASSERT_EQ(pieces(mesh, 1).size(), 20u);
  options.attributes = {parse_size_attribute("Edge1=/20"), parse_size_attribute("Edge2=/7")};
  EXPECT_TRUE(surplus_vertices(mesh, box, edge_divisions(box, options.attributes)).empty());
  options.attributes = {parse_size_attribute("Edge1=/10")};
  const std::vector<int> ten = edge_divisions(box, options.attributes);
  const std::vector<Mesh::Index> surplus = surplus_vertices(mesh, box, ten);
  ASSERT_EQ(surplus.size(), 10u);
  for (const Mesh::Index v : surplus) EXPECT_EQ(mesh.point_on[v], model_edge(1));
  FinalizeOptions finalization;
  finalization.size_at = [](const Vec3&) { return 3.0; };
  draw_in(mesh, box, finalization, surplus);
  const std::vector<double> lengths = pieces(mesh, 1);
  ASSERT_EQ(lengths.size(), 10u);
  EXPECT_LT(lengths.back(), 1.001 * lengths.front());
  EXPECT_TRUE(accept_mesh(mesh, box).holds());
  EXPECT_TRUE(surplus_vertices(mesh, box, ten).empty());
}

}  // namespace
}  // namespace octet
