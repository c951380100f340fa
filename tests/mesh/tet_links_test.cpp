// SPDX-License-Identifier: BSD-3-Clause
// Neighbours point back to each other, and walls are the mesh's triangles.
#include "mesh/tet_links.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(TetLinks, NeighboursPointBackAndWallsAreTheTriangles) {
  const Mesh mesh = test::plain_box_mesh(3);
  const TetLinks links = tet_links(mesh);
  std::size_t walls = 0, outer = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const Mesh::Index n = links.neighbour[t][f];
      walls += links.wall[t][f];
      outer += n == kNoTet;
      EXPECT_EQ(links.wall[t][f], n == kNoTet);
      if (n == kNoTet) continue;
      const auto& back = links.neighbour[n];
      EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<Mesh::Index>(t)), 1);
    }
  }
  EXPECT_EQ(walls, mesh.triangles.size());
  EXPECT_EQ(outer, 6u * 9u * 2u);
}

}  // namespace
}  // namespace octet
