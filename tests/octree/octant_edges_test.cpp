// SPDX-License-Identifier: BSD-3-Clause
#include "octree/octant_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/octree/random_trees.h"

namespace octet {
namespace {

/// The edges of all octants, halved wherever a vertex lies in the middle, by looking every midpoint up.
std::vector<OctantEdge> edges_by_brute_force(const Octree& tree, const OctreeVertices& vertices) {
  std::vector<OctantEdge> edges;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    for (unsigned from = 0; from < 8; ++from) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        if ((from >> axis & 1u) != 0) continue;
        const std::uint32_t a = vertices.corners[i][from], b = vertices.corners[i][from | 1u << axis];
        Lattice middle = vertices.at[a];
        middle[axis] += tree[OctantId(i)].extent() / 2;
        const std::uint32_t m = vertices.find(middle);
        if (m == kNoVertex) {
          edges.push_back({a, b});
        } else {
          edges.push_back({a, m});
          edges.push_back({m, b});
        }
      }
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

OctantTypes all_boundary(const Octree& tree) {
  return {std::vector<OctantType>(tree.size(), OctantType::kBoundary),
          std::vector<std::int32_t>(tree.size(), 0)};
}

TEST(OctantEdges, EqualBruteForce) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Octree tree = test::random_tree(seed, 30, 6);
    const OctreeVertices vertices = octree_vertices(tree);
    EXPECT_EQ(boundary_octant_edges(tree, vertices, all_boundary(tree)),
              edges_by_brute_force(tree, vertices));
  }
}

TEST(OctantEdges, AUniformTreeHasAsManyAsALattice) {
  const Octree tree = test::uniform_tree(3);
  EXPECT_EQ(boundary_octant_edges(tree, octree_vertices(tree), all_boundary(tree)).size(), 3u * 8 * 9 * 9);
}

TEST(OctantEdges, RunUpTheAxisWithoutAVertexBetween) {
  const Octree tree = test::random_tree(31);
  const OctreeVertices vertices = octree_vertices(tree);
  for (const OctantEdge& e : boundary_octant_edges(tree, vertices, all_boundary(tree))) {
    const Lattice &a = vertices.at[e.from], &b = vertices.at[e.to];
    const std::array<bool, 3> moves{a[0] < b[0], a[1] < b[1], a[2] < b[2]};
    EXPECT_LT(e.from, e.to);
    EXPECT_EQ(std::ranges::count(moves, true), 1);
    EXPECT_EQ(vertices.find({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}), kNoVertex);
  }
}

TEST(OctantEdges, AreThoseOfBoundaryOctantsOnly) {
  const Octree tree = test::uniform_tree(2);
  OctantTypes types = all_boundary(tree);
  std::ranges::fill(types.type, OctantType::kIn);
  EXPECT_TRUE(boundary_octant_edges(tree, octree_vertices(tree), types).empty());
  types.type[5] = OctantType::kBoundary;
  EXPECT_EQ(boundary_octant_edges(tree, octree_vertices(tree), types).size(), 12u);
}

}  // namespace
}  // namespace octet
