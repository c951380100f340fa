// SPDX-License-Identifier: BSD-3-Clause
// Edges once each, whatever elements have them.
#include "mesh/edges.h"

#include <gtest/gtest.h>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(Edges, ComeOnceEachAsEulerCounts) {
  const Mesh mesh = test::plain_box_mesh(3);
  const auto edges = element_edges(mesh);
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  // V - E + F - T = 1 for a ball; 2 F = 4 T + boundary triangles.
  const std::size_t faces = (4 * mesh.tets.size() + mesh.triangles.size()) / 2;
  EXPECT_EQ(mesh.points.size() + faces, edges.size() + mesh.tets.size() + 1);
}

TEST(Edges, OfElementsThatNoTetrahedronHasAreListedToo) {
  Mesh mesh;
  mesh.points.resize(7);
  mesh.tets = {{0, 3, 1, 2}};
  mesh.triangles = {{2, 5, 4}};
  mesh.edges = {{6, 5}};
  EXPECT_EQ(element_edges(mesh),
            (std::vector<EdgeEnds>{
                {0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {2, 4}, {2, 5}, {4, 5}, {5, 6}}));
}

}  // namespace
}  // namespace octet
