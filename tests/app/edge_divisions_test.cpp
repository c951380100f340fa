// SPDX-License-Identifier: BSD-3-Clause
// Numbers of elements on edges.
#include "app/edge_divisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/mesh_part.h"
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

}  // namespace
}  // namespace octet
