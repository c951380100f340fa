// SPDX-License-Identifier: BSD-3-Clause
// Edges once each, and a size per vertex that follows them.
#include "mesh/local_size.h"

#include <gtest/gtest.h>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(LocalSize, EdgesComeOnceEachAsEulerCounts) {
  const Mesh mesh = test::plain_box_mesh(3);
  const auto edges = tet_edges(mesh);
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  // V - E + F - T = 1 for a ball; 2 F = 4 T + boundary triangles.
  const std::size_t faces = (4 * mesh.tets.size() + mesh.triangles.size()) / 2;
  EXPECT_EQ(mesh.points.size() + faces, edges.size() + mesh.tets.size() + 1);
}

TEST(LocalSize, ScalesWithTheMesh) {
  Mesh mesh = test::plain_box_mesh(2);
  const auto edges = tet_edges(mesh);
  const auto size = vertex_sizes(mesh, edges);
  for (Vec3& p : mesh.points) p *= 3.0;
  const auto scaled = vertex_sizes(mesh, edges);
  for (std::size_t v = 0; v < size.size(); ++v) {
    EXPECT_GT(size[v], 0.5);  // cells of 1.5, 1 and 0.5
    EXPECT_LT(size[v], 1.9);
    EXPECT_NEAR(scaled[v], 3.0 * size[v], 1e-12);
  }
}

}  // namespace
}  // namespace octet
