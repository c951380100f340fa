// SPDX-License-Identifier: BSD-3-Clause
// One node for each edge, in its middle, on what holds it.
#include "mesh/mid_nodes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesh/tet_mesh.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

using Ends = std::array<Mesh::Index, 2>;

Ends ascending(Mesh::Index a, Mesh::Index b) { return {std::min(a, b), std::max(a, b)}; }

TEST(MidNodes, AreOneForEveryEdgeInTheOrderOfTheirEnds) {
  const Mesh mesh = test::plain_box_mesh(3);
  std::set<Ends> edges;
  for (const auto& tet : mesh.tets)
    for (const auto& [i, j] : kTetEdge) edges.insert(ascending(tet[i], tet[j]));
  const MidNodes mid = straight_mid_nodes(mesh);
  EXPECT_EQ(mid.between, std::vector<Ends>(edges.begin(), edges.end()));
  ASSERT_EQ(mid.points.size(), edges.size());
  for (std::size_t m = 0; m < mid.points.size(); ++m)
    EXPECT_EQ(mid.points[m], 0.5 * (mesh.points[mid.between[m][0]] + mesh.points[mid.between[m][1]]));
}

TEST(MidNodes, AreThoseOfTheElementsEdges) {
  const Mesh mesh = test::plain_box_mesh(2);
  const MidNodes mid = straight_mid_nodes(mesh);
  ASSERT_EQ(mid.of_tets.size(), mesh.tets.size());
  ASSERT_EQ(mid.of_triangles.size(), mesh.triangles.size());
  ASSERT_EQ(mid.of_edges.size(), mesh.edges.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_EQ(mid.between[mid.of_tets[t][e]],
                ascending(mesh.tets[t][kTetEdge[e][0]], mesh.tets[t][kTetEdge[e][1]]));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(mid.between[mid.of_triangles[t][k]],
                ascending(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]));
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    EXPECT_EQ(mid.between[mid.of_edges[e]], ascending(mesh.edges[e][0], mesh.edges[e][1]));
}

TEST(MidNodes, AreOnWhatHoldsTheEdge) {
  const Vec3 size(3.0, 2.0, 1.0);
  const Mesh mesh = test::plain_box_mesh(3);
  const test::BoxPart part = test::plain_box(size);
  const MidNodes mid = straight_mid_nodes(mesh);
  std::map<int, int> by_dimension;
  for (std::size_t m = 0; m < mid.points.size(); ++m) {
    EXPECT_EQ(mid.on[m], part.on(mid.points[m])) << m;
    ++by_dimension[mid.on[m].dim];
  }
  EXPECT_EQ(by_dimension[1], 12 * 3);  // pieces of the box's edges
  EXPECT_GT(by_dimension[2], 0);
  EXPECT_GT(by_dimension[3], 0);
}

TEST(MidNodes, OfAMeshWithoutElementsAreNone) { EXPECT_TRUE(straight_mid_nodes(Mesh{}).empty()); }

}  // namespace
}  // namespace octet
