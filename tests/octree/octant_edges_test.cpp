// SPDX-License-Identifier: BSD-3-Clause
#include "octree/octant_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/octree/random_trees.h"

namespace octet {
namespace {

/// The edges of all octants, halved wherever a vertex lies in the middle, by looking every midpoint up, and
/// the lines between the centres of octants of one level, by comparing all with all; then the diagonals.
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
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    for (std::uint32_t j = i + 1; j < tree.size(); ++j) {
      const Octant &a = tree[OctantId(i)], &b = tree[OctantId(j)];
      int same = 0, beside = 0;
      for (int axis = 0; axis < 3; ++axis) {
        same += a.corner[axis] == b.corner[axis];
        beside +=
            a.corner[axis] + a.extent() == b.corner[axis] || b.corner[axis] + a.extent() == a.corner[axis];
      }
      if (a.level == b.level && same == 2 && beside == 1)
        edges.push_back({vertices.centre(OctantId(i)), vertices.centre(OctantId(j))});
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<OctantEdge> diagonals;
  for (std::size_t i = 0; i < tree.size(); ++i)
    for (const std::uint32_t corner : vertices.corners[i])
      diagonals.push_back({corner, vertices.centre(OctantId(i))});
  std::ranges::sort(diagonals, {}, [](const OctantEdge& e) { return std::pair(e.to, e.from); });
  edges.insert(edges.end(), diagonals.begin(), diagonals.end());
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
    std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, all_boundary(tree));
    const auto expected = edges_by_brute_force(tree, vertices);
    const auto diagonals = edges.end() - static_cast<std::ptrdiff_t>(8 * tree.size());
    std::sort(diagonals, edges.end(), [](const OctantEdge& a, const OctantEdge& b) {
      return std::pair(a.to, a.from) < std::pair(b.to, b.from);
    });
    EXPECT_EQ(edges, expected);
  }
}

TEST(OctantEdges, AUniformTreeHasAsManyAsALattice) {
  const Octree tree = test::uniform_tree(3);
  EXPECT_EQ(boundary_octant_edges(tree, octree_vertices(tree), all_boundary(tree)).size(),
            3u * 8 * 9 * 9 + 3u * 7 * 8 * 8 + 8u * 8 * 8 * 8);
}

TEST(OctantEdges, RunAlongAnAxisOrADiagonalWithoutACornerBetween) {
  const Octree tree = test::random_tree(31);
  const OctreeVertices vertices = octree_vertices(tree);
  for (const OctantEdge& e : boundary_octant_edges(tree, vertices, all_boundary(tree))) {
    const Lattice &a = vertices.at[e.from], &b = vertices.at[e.to];
    const std::array<bool, 3> moves{a[0] != b[0], a[1] != b[1], a[2] != b[2]};
    EXPECT_LT(e.from, e.to);
    const bool is_diagonal = e.from < vertices.corner_count() && e.to >= vertices.corner_count();
    EXPECT_EQ(std::ranges::count(moves, true), is_diagonal ? 3 : 1);
    if (e.to < vertices.corner_count()) {
      EXPECT_EQ(vertices.find({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}), kNoVertex);
    }
  }
}

TEST(OctantEdges, AreThoseOfBoundaryOctantsOnly) {
  const Octree tree = test::uniform_tree(2);
  OctantTypes types = all_boundary(tree);
  std::ranges::fill(types.type, OctantType::kIn);
  EXPECT_TRUE(boundary_octant_edges(tree, octree_vertices(tree), types).empty());
  types.type[5] = OctantType::kBoundary;
  EXPECT_EQ(boundary_octant_edges(tree, octree_vertices(tree), types).size(),
            12u + 8u + 5u);  // octant 5 of 64 lies on one face of the root
}

}  // namespace
}  // namespace octet
