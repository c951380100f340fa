// SPDX-License-Identifier: BSD-3-Clause
// What forbids good elements is found where it is, and nowhere else.
#include "mesh/forbidden.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

using test::box_mesh;
using test::plain_box;

std::size_t flagged(const Mesh& mesh, double size) {
  const std::vector<double> sizes(mesh.points.size(), size);
  const auto flags = forbidding_vertices(mesh, sizes);
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

TEST(Forbidden, ABoxForbidsNothingUntilItsWallIsThinnerThanTheSize) {
  const Vec3 size(3.0, 2.0, 1.0);
  const Mesh mesh = box_mesh(plain_box(size), size, {3, 2, 2});
  EXPECT_EQ(flagged(mesh, 0.99), 0u);
  // Top and bottom are one unit apart: all of their vertices are flagged, those at half height are not.
  EXPECT_EQ(flagged(mesh, 1.01), 24u);
}

TEST(Forbidden, AWedgeIsSharpFromThirtyFiveDegreesDown) {
  const Vec3 size(1.0, 1.0, 1.0);
  const auto sheared = [&](double degrees) {
    // The edge x = 0, z = 0 closes at this angle: the face x = 0 is leaned over.
    Mesh mesh = box_mesh(plain_box(size), size, {2, 2, 2});
    for (Vec3& p : mesh.points) p.x() += p.z() / std::tan(degrees * M_PI / 180.0);
    return mesh;
  };
  const double tiny = 1e-3;
  EXPECT_EQ(flagged(sheared(36.0), tiny), 0u);
  const Mesh sharp = sheared(34.0);
  const std::vector<double> sizes(sharp.points.size(), tiny);
  const auto flags = forbidding_vertices(sharp, sizes);
  for (std::size_t v = 0; v < flags.size(); ++v) {
    const Vec3& p = sharp.points[v];
    const double u = p.x() - p.z() / std::tan(34.0 * M_PI / 180.0);
    // That edge and the one across.
    const bool on_edge = (std::abs(u) < 1e-9 && p.z() == 0.0) || (std::abs(u - 1.0) < 1e-9 && p.z() == 1.0);
    EXPECT_EQ(flags[v] != 0, on_edge) << p.transpose();
  }
}

TEST(Forbidden, TwoEdgesThatMeetAtASmallAngleFlagTheirVertex) {
  const Vec3 size(1.0, 1.0, 1.0);
  Mesh mesh = box_mesh(plain_box(size), size, {1, 1, 1});
  ASSERT_EQ(flagged(mesh, 1e-3), 0u);
  // Edges of the model, though not of the box: from the corner at the origin to both ends of another edge.
  const auto at = [&](const Vec3& p) {
    return static_cast<Mesh::Index>(std::find(mesh.points.begin(), mesh.points.end(), p) -
                                    mesh.points.begin());
  };
  mesh.points[at(Vec3(1, 1, 0))] = Vec3(1, 0.5, 0);
  EXPECT_EQ(flagged(mesh, 1e-3), 0u);
  mesh.edges.push_back({at(Vec3(0, 0, 0)), at(Vec3(1, 0.5, 0))});
  mesh.edge_on.push_back(99);
  EXPECT_EQ(flagged(mesh, 1e-3), 1u);
}

TEST(Forbidden, AStripNarrowerThanAThirdOfTheSizeFlagsBothItsEdges) {
  // The step's face x in [0, 1] x y in [0, 0.3]: its long edges are one element apart.
  const Vec3 size(1.0, 0.3, 4.0);
  const Mesh mesh = box_mesh(plain_box(size), size, {2, 1, 8});
  EXPECT_GT(flagged(mesh, 0.8), 0u) << "thin wall";
  Mesh wide = mesh;
  for (Vec3& p : wide.points) p.y() *= 3.0;
  EXPECT_EQ(flagged(wide, 0.8), 0u);
  // One edge of a thick box drawn near to another.
  Mesh notched = wide;
  for (Vec3& p : notched.points)
    if (p.x() == 0.0 && p.z() > 0.9 && p.z() < 3.1) p.y() = 0.9 - 0.25 * (0.9 - p.y());
  const std::vector<double> sizes(notched.points.size(), 0.8);
  const auto flags = forbidding_vertices(notched, sizes);
  for (std::size_t v = 0; v < flags.size(); ++v) {
    const Vec3& p = notched.points[v];
    if (p.x() == 0.0 && p.z() > 0.9 && p.z() < 3.1) {
      EXPECT_TRUE(flags[v]) << p.transpose();
    }
  }
}

TEST(Forbidden, ACuspFlagsAVertexNearToThePieceAcrossThoughFarFromItsEnds) {
  const Vec3 size(1.0, 1.0, 1.0);
  Mesh mesh = box_mesh(plain_box(size), size, {2, 2, 2});
  ASSERT_EQ(flagged(mesh, 0.5), 0u);
  // The vertex in the middle of a face comes to lie on an edge of its own, near to a piece of the box's.
  const auto is_piece = [&](Mesh::Index a, Mesh::Index b) {
    return std::any_of(mesh.edges.begin(), mesh.edges.end(),
                       [&](const auto& e) { return std::minmax(e[0], e[1]) == std::minmax(a, b); });
  };
  const auto cusp = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& v) {
    return mesh.point_on[v[0]].dim == 2 && is_piece(v[1], v[2]);
  });
  ASSERT_NE(cusp, mesh.triangles.end());
  const auto [apex, a, b] = *cusp;
  const Vec3 middle = 0.5 * (mesh.points[a] + mesh.points[b]);
  mesh.points[apex] = middle + 0.2 * (mesh.points[apex] - middle);
  EXPECT_EQ(flagged(mesh, 0.5), 0u);
  mesh.point_on[apex] = model_edge(99);
  EXPECT_EQ(flagged(mesh, 0.5), 3u);
}

TEST(Forbidden, AnElementTouchesByOneVertex) {
  const std::vector<char> flags{0, 0, 1, 0, 0};
  EXPECT_TRUE(touches({0, 1, 2, 3}, flags));
  EXPECT_FALSE(touches({0, 1, 3, 4}, flags));
}

}  // namespace
}  // namespace octet
