// SPDX-License-Identifier: BSD-3-Clause
// A size per vertex that follows the edges.
#include "mesh/local_size.h"

#include <gtest/gtest.h>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(LocalSize, ScalesWithTheMesh) {
  Mesh mesh = test::plain_box_mesh(2);
  const auto edges = element_edges(mesh);
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
