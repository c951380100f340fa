// SPDX-License-Identifier: BSD-3-Clause
// Curved elements follow the CAD and never turn over.
#include "finalize/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/mid_nodes.h"
#include "mesh/quadratic.h"
#include "tests/finalize/parts.h"
#include "tests/support/model_meshes.h"

namespace octet {
namespace {

CurveReport curve(Mesh& mesh, const Model& model) {
  Observer silent;
  return curve_mesh(mesh, model, silent);
}

double volume_of(const Mesh& mesh) {
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) volume += jacobian_form(quadratic_tet(mesh, t)).volume();
  return volume;
}

double least_of(const Mesh& mesh) {
  double least = 1.0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    least = std::min(least, scaled_jacobian(jacobian_form(quadratic_tet(mesh, t))));
  return least;
}

TEST(Curve, LeavesAPlanarPartStraight) {
  testing::Part part = testing::box_part(Vec3(1, 1, 1), 3, 3, 3);
  const CurveReport report = curve(part.mesh, part.model);
  EXPECT_EQ(report.curved, 0u);
  EXPECT_TRUE(report.held.empty());
  EXPECT_EQ(report.least_scaled_jacobian, 1.0);
  EXPECT_EQ(part.mesh.mid.points, straight_mid_nodes(part.mesh).points);
}

TEST(Curve, PutsNodesOnTheBall) {
  const Model model = analytic_ball(1.0);
  Mesh mesh = test::ball_mesh(model, 1.0, 3);
  const CurveReport report = curve(mesh, model);
  EXPECT_TRUE(report.held.empty());
  std::size_t on_face = 0;
  for (std::size_t m = 0; m < mesh.mid.points.size(); ++m) {
    if (mesh.mid.on[m].dim == 3) continue;
    ++on_face;
    EXPECT_NEAR(mesh.mid.points[m].norm(), 1.0, 1e-12);
  }
  EXPECT_EQ(report.curved, on_face);
  EXPECT_GE(least_of(mesh), kLeastScaledJacobian);
  EXPECT_EQ(report.least_scaled_jacobian, least_of(mesh));
}

/// Edges halve from level to level, and the error is to fall as their third power at least.
TEST(Curve, TheBallsVolumeIsOfThirdOrderAtLeast) {
  const Model model = analytic_ball(1.0);
  const double exact = 4.0 / 3.0 * std::acos(-1.0);
  double before = 0.0;
  for (int levels = 1; levels <= 4; ++levels) {
    Mesh mesh = test::ball_mesh(model, 1.0, levels);
    (void)curve(mesh, model);
    const double error = std::abs(volume_of(mesh) / exact - 1.0);
    if (levels > 1) {
      EXPECT_LT(error, before / 8.0) << levels;
    }
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(Curve, NodesOnCirclesAreHalfWayAlongThem) {
  const Model model = analytic_cylinder(1.0, 1.5);
  constexpr int kAround = 12;
  Mesh mesh = test::cylinder_mesh(model, 1.0, 1.5, kAround, 3);
  const CurveReport report = curve(mesh, model);
  EXPECT_GE(least_of(mesh), kLeastScaledJacobian);
  const double half = std::acos(-1.0) / kAround;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Vec3& middle = mesh.mid.points[mesh.mid.of_edges[e]];
    EXPECT_NEAR(std::hypot(middle.x(), middle.y()), 1.0, 1e-12);
    for (const Mesh::Index v : mesh.edges[e])
      EXPECT_NEAR((middle - mesh.points[v]).norm(), 2.0 * std::sin(0.5 * half), 1e-9);
  }
  ASSERT_TRUE(report.farthest.has_value());
  EXPECT_LT(report.farthest->distance, 0.1 * (1.0 - std::cos(half)));
}

/// An arc of 150 degrees: a parabola through its middle is no likeness of it, and that is told.
TEST(Curve, LeavesAnEdgeStraightAndSaysSoWhereItsArcIsTooLong) {
  const Model model = analytic_cylinder(1.0, 1.5);
  int circle = 1;
  while (model.edge(circle).use != EdgeUse::kReal) ++circle;
  const double z = model.edge_point(circle, model.edge(circle).t0).z();
  const auto at = [&](double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    return Vec3(std::cos(angle), std::sin(angle), z);
  };
  Mesh mesh;
  mesh.points = {at(20.0), at(170.0), at(270.0), Vec3(0.0, 0.0, 0.75)};
  mesh.point_on = {model_edge(circle), model_edge(circle), model_edge(circle), model_region(1)};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.tet_in = {1};
  mesh.edges = {{0, 1}};
  mesh.edge_on = {circle};
  test::orient_tets(mesh);
  const CurveReport report = curve(mesh, model);
  EXPECT_EQ(mesh.mid.points, straight_mid_nodes(mesh).points);
  EXPECT_EQ(report.curved, 0u);
  ASSERT_EQ(report.held.size(), 1u);
  EXPECT_EQ(report.held[0].entity, model_edge(circle));
  EXPECT_NEAR(report.held[0].distance, 1.0 - std::cos(75.0 * std::acos(-1.0) / 180.0), 1e-9);
}

/// An element with two faces on one smooth face has no angle left between them where both follow it: its
/// nodes on that face go back as far as it needs, and those of the others stay where they are.
TEST(Curve, HoldsBackWhereAnElementHasTwoTrianglesOnOneRoundFace) {
  const Model model = analytic_ball(1.0);
  Mesh mesh = test::ball_mesh(model, 1.0, 2);
  // A tetrahedron under two triangles that share a side, in the place of the two of the centre's there.
  std::size_t other = 1;
  std::array<Mesh::Index, 2> shared{};
  const auto& first = mesh.triangles[0];
  for (; other < mesh.triangles.size(); ++other) {
    std::vector<Mesh::Index> both;
    for (const Mesh::Index v : mesh.triangles[other])
      if (std::find(first.begin(), first.end(), v) != first.end()) both.push_back(v);
    if (both.size() != 2) continue;
    shared = {both[0], both[1]};
    break;
  }
  const auto beyond = [&](const std::array<Mesh::Index, 3>& triangle) {
    for (const Mesh::Index v : triangle)
      if (v != shared[0] && v != shared[1]) return v;
    return shared[0];
  };
  const Mesh::Index a = beyond(first), b = beyond(mesh.triangles[other]);
  const Mesh::Index centre = static_cast<Mesh::Index>(mesh.points.size() - 1);
  mesh.tets[0] = {centre, a, b, shared[0]};
  mesh.tets[other] = {centre, a, b, shared[1]};
  mesh.tets.push_back({a, b, shared[0], shared[1]});
  mesh.tet_in.push_back(1);
  test::orient_tets(mesh);
  Mesh free = mesh;
  free.mid = straight_mid_nodes(free);
  for (std::size_t m = 0; m < free.mid.points.size(); ++m)
    if (free.mid.on[m].dim == 2) free.mid.points[m].normalize();
  ASSERT_LT(least_of(free), kLeastScaledJacobian);

  const CurveReport report = curve(mesh, model);
  EXPECT_GE(least_of(mesh), kLeastScaledJacobian);
  ASSERT_FALSE(report.held.empty());
  EXPECT_LE(report.held.size(), 5u);  // of the element's edges on the ball
  EXPECT_EQ(report.held.front().entity, model_face(1));
  EXPECT_GT(report.held.front().distance, 0.0);
  for (std::size_t i = 1; i < report.held.size(); ++i)
    EXPECT_GE(report.held[i - 1].distance, report.held[i].distance);
  std::size_t off = 0;
  for (std::size_t m = 0; m < mesh.mid.points.size(); ++m)
    if (mesh.mid.on[m].dim == 2 && std::abs(mesh.mid.points[m].norm() - 1.0) > 1e-12) ++off;
  EXPECT_EQ(off, report.held.size());
}

}  // namespace
}  // namespace octet
