// SPDX-License-Identifier: BSD-3-Clause
// The bounds hold, the measures are exact, and a turned-over element is never called good.
#include "mesh/quadratic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "mesh/mid_nodes.h"
#include "mesh/quality.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

using Shape = std::array<double, 4>;  // barycentric coordinates

QuadraticTet straight(const std::array<Vec3, 4>& corners) {
  QuadraticTet tet;
  for (std::size_t i = 0; i < 4; ++i) tet[i] = corners[i];
  for (std::size_t e = 0; e < 6; ++e)
    tet[4 + e] =
        0.5 * (tet[static_cast<std::size_t>(kTetEdge[e][0])] + tet[static_cast<std::size_t>(kTetEdge[e][1])]);
  return tet;
}

/// Nodes in the middles of edges moved by up to `amount` along each axis.
QuadraticTet bent(double amount, std::uint32_t seed) {
  std::mt19937 dice(seed);
  QuadraticTet tet =
      straight({Vec3(0.1, 0, 0.2), Vec3(1.3, 0.1, 0), Vec3(0, 1.1, -0.2), Vec3(0.3, 0.2, 0.9)});
  for (std::size_t n = 4; n < 10; ++n)
    for (int i = 0; i < 3; ++i) tet[n][i] += amount * (2.0 * (dice() % 1001) / 1000.0 - 1.0);
  return tet;
}

/// Derivatives of the map by the textbook's shape functions, L(2L - 1) and 4 L L'.
double determinant(const QuadraticTet& tet, const Shape& l) {
  std::array<Vec3, 4> by;  // along each barycentric coordinate
  for (std::size_t i = 0; i < 4; ++i) by[i] = (4.0 * l[i] - 1.0) * tet[i];
  for (std::size_t e = 0; e < 6; ++e) {
    const auto i = static_cast<std::size_t>(kTetEdge[e][0]), j = static_cast<std::size_t>(kTetEdge[e][1]);
    by[i] += 4.0 * l[j] * tet[4 + e];
    by[j] += 4.0 * l[i] * tet[4 + e];
  }
  return (by[1] - by[0]).cross(by[2] - by[0]).dot(by[3] - by[0]);
}

template <class Visit>
void for_each_place(int n, const Visit& visit) {
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      for (int k = 0; i + j + k <= n; ++k)
        visit(Shape{double(i) / n, double(j) / n, double(k) / n, double(n - i - j - k) / n});
}

TEST(JacobianForm, IsSixVolumesThroughoutWhereEdgesAreStraight) {
  const QuadraticTet tet = bent(0.0, 1);
  const double volume = signed_volume(tet[0], tet[1], tet[2], tet[3]);
  const JacobianForm form = jacobian_form(tet);
  for (const double value : form.coefficient) EXPECT_NEAR(value, 6.0 * volume, 1e-14);
  EXPECT_NEAR(form.volume(), volume, 1e-15);
  EXPECT_NEAR(scaled_jacobian(form), 1.0, 1e-13);
}

TEST(JacobianForm, BoundsTheDeterminantAndMeetsItAtCorners) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const QuadraticTet tet = bent(0.15, seed);
    const JacobianForm form = jacobian_form(tet);
    for_each_place(8, [&](const Shape& l) {
      const double value = determinant(tet, l);
      ASSERT_GE(value, form.least() - 1e-12);
      ASSERT_LE(value, form.largest() + 1e-12);
    });
    for (std::size_t i = 0; i < 4; ++i) {
      Shape corner{};
      corner[i] = 1.0;
      EXPECT_NEAR(form.coefficient[i], determinant(tet, corner), 1e-12);
    }
  }
}

/// The determinant is a cubic: Simpson's rule along each direction of a cube drawn to a simplex would do, but
/// the midpoint rule over many cells needs no theory.
TEST(JacobianForm, GivesTheVolumeOfCurvedElements) {
  const QuadraticTet tet = bent(0.2, 7);
  constexpr int kCells = 60;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j)
      for (int k = 0; k < kCells; ++k) {
        // The cube to the simplex: r = u, s = v (1 - u), t = w (1 - u)(1 - v).
        const double u = (i + 0.5) / kCells, v = (j + 0.5) / kCells, w = (k + 0.5) / kCells;
        const double r = u, s = v * (1.0 - u), t = w * (1.0 - u) * (1.0 - v);
        sum += determinant(tet, {1.0 - r - s - t, r, s, t}) * (1.0 - u) * (1.0 - u) * (1.0 - v);
      }
  const double volume = sum / (kCells * kCells * kCells);
  EXPECT_NEAR(jacobian_form(tet).volume(), volume, 2e-4 * volume);
}

TEST(LeastJacobian, IsWithinTheAccuracyBelowTheLeastValue) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const QuadraticTet tet = bent(0.2, seed);
    double least = std::numeric_limits<double>::infinity();
    for_each_place(24, [&](const Shape& l) { least = std::min(least, determinant(tet, l)); });
    const double bound = least_jacobian(jacobian_form(tet), 1e-3);
    EXPECT_LE(bound, least + 1e-12);
    // The finest of the places above are a 24th apart, which leaves the determinant some way to fall.
    EXPECT_GE(bound, least - 1e-3 - 2e-2);
  }
}

/// The least coefficient is below nought where the determinant nowhere is; halving tells.
TEST(LeastJacobian, FindsAnElementGoodThatItsCoefficientsLeaveInDoubt) {
  std::size_t in_doubt = 0, over = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const QuadraticTet tet = bent(0.25, seed);
    const JacobianForm form = jacobian_form(tet);
    double least = std::numeric_limits<double>::infinity();
    for_each_place(24, [&](const Shape& l) { least = std::min(least, determinant(tet, l)); });
    const double bound = least_jacobian(form, 1e-4);
    if (form.least() <= 0.0 && least > 0.02) {
      ++in_doubt;
      EXPECT_GT(bound, 0.0) << seed;
    }
    if (least <= 0.0) {
      ++over;
      EXPECT_LE(bound, 0.0) << seed;
    }
  }
  EXPECT_GT(in_doubt, 0u);
  EXPECT_GT(over, 0u);
}

TEST(LeastJacobian, IsNotAboveNoughtForAnElementTurnedOver) {
  QuadraticTet tet = straight({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
  tet[4 + 0] = Vec3(0.5, 0.8, 0.8);  // the middle of edge 0-1 through the opposite edge
  EXPECT_LT(least_jacobian(jacobian_form(tet), 1e-3), 0.0);
  std::swap(tet[0], tet[1]);
  EXPECT_LT(scaled_jacobian(jacobian_form(straight({tet[0], tet[1], tet[2], tet[3]}))), 0.0);
}

TEST(QuadraticVolume, IsThatOfTheCornersWhereEdgesAreStraightAndOfTheFormElsewhere) {
  Mesh mesh;
  const QuadraticTet bent_tet = bent(0.1, 3);
  mesh.points.assign(bent_tet.begin(), bent_tet.begin() + 4);
  mesh.tets = {{0, 1, 2, 3}};
  mesh.tet_in = {1};
  mesh.mid = straight_mid_nodes(mesh);
  EXPECT_TRUE(has_straight_edges(mesh, 0));
  EXPECT_EQ(quadratic_volume(mesh, 0), signed_volume(bent_tet[0], bent_tet[1], bent_tet[2], bent_tet[3]));
  for (std::size_t e = 0; e < 6; ++e) mesh.mid.points[mesh.mid.of_tets[0][e]] = bent_tet[4 + e];
  EXPECT_FALSE(has_straight_edges(mesh, 0));
  EXPECT_EQ(quadratic_volume(mesh, 0), jacobian_form(bent_tet).volume());
}

TEST(QuadraticArea, IsThatOfAParabolicStripAndOfABentOutline) {
  Mesh mesh;
  // z = x (1 - x) over the unit triangle, whose middles lie on it: the map is that surface itself.
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}};
  mesh.mid.points = {Vec3(0.5, 0, 0.25), Vec3(0.5, 0.5, 0.25), Vec3(0, 0.5, 0)};
  mesh.mid.of_triangles = {{0, 1, 2}};
  double area = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps;
    area += (1.0 - x) * std::hypot(1.0, 1.0 - 2.0 * x) / kSteps;
  }
  EXPECT_NEAR(quadratic_area(mesh, 0), area, 2e-4);
  // In the plane a side that bulges by d adds the segment of a parabola, 2/3 d of its length.
  mesh.mid.points = {Vec3(0.5, -0.1, 0), Vec3(0.5, 0.5, 0), Vec3(0, 0.5, 0)};
  EXPECT_NEAR(quadratic_area(mesh, 0), 0.5 + 2.0 / 3.0 * 0.1, 1e-12);
}

}  // namespace
}  // namespace octet
