// SPDX-License-Identifier: BSD-3-Clause
// The guard's books of areas: what operators change is in them, and what would make fillets coarser is
// refused.
#include "finalize/boundary_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "base/observer.h"
#include "finalize/improve.h"
#include "finalize/relax.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::Part;

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += triangle_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  return sum;
}

TEST(BoundaryGuard, SumsTheFacesErrorsOfArea) {
  const Part part = testing::ball_part(5);
  const BoundaryGuard guard(part.model, to_work_mesh(part.mesh));
  EXPECT_NEAR(guard.area_error(), 4.0 * std::numbers::pi - area(part.mesh), 1e-12);
}

TEST(BoundaryGuard, GuardedAreasGetATenthWorseAtMost) {
  const Part part = testing::ball_part(5);
  BoundaryGuard guard(part.model, to_work_mesh(part.mesh));
  const double error = guard.area_error();
  const auto smaller_by = [](double area) { return std::array{MeasureChange{model_face(1), -area}}; };
  EXPECT_TRUE(guard.admits(smaller_by(0.2 * error)));
  guard.guard_areas(true);
  EXPECT_FALSE(guard.admits(smaller_by(0.2 * error)));
  EXPECT_TRUE(guard.admits(smaller_by(0.09 * error)));
  EXPECT_TRUE(guard.admits(smaller_by(-0.2 * error)));
  // Too large is as far off as too small.
  EXPECT_TRUE(guard.admits(smaller_by(-2.0 * error)));
  EXPECT_FALSE(guard.admits(smaller_by(-2.2 * error)));
  guard.take(smaller_by(0.09 * error));
  EXPECT_NEAR(guard.area_error(), 1.09 * error, 1e-12);
  EXPECT_FALSE(guard.admits(smaller_by(0.09 * error)));
}

TEST(BoundaryGuard, WhatIsWithinItsRoomStaysSoAndWhatIsNotIsToStay) {
  const Part part = testing::ball_part(5);
  const BoundaryGuard guard(part.model, to_work_mesh(part.mesh));
  const auto sag = [](double value) {
    Fit fit;
    fit.sag = value;
    return fit;
  };
  constexpr double kSize = 0.4, kWide = std::numeric_limits<double>::infinity();
  const double wide = guard.bound(sag(0.002), kSize, kWide).sag;
  ASSERT_GT(wide, 0.01);
  EXPECT_EQ(guard.bound(sag(0.002), kSize, 0.01).sag, 0.01);
  EXPECT_EQ(guard.bound(sag(0.002), kSize, 2.0 * wide).sag, wide);
  EXPECT_FALSE(BoundaryGuard::within(sag(0.0), guard.bound(sag(0.011), kSize, 0.01)));
  EXPECT_EQ(guard.piece_bound(0.002, 0.01), 0.01);
  EXPECT_GT(guard.piece_bound(0.002, kWide), 0.01);
  EXPECT_LT(guard.piece_bound(0.011, 0.01), 0.0);
}

/// The triangles that are farther than that from the sphere, at their centroids or their edges' middles, by
/// their corners' places.
std::set<std::array<std::array<double, 3>, 3>> beyond(const Mesh& mesh, double radius, double far) {
  std::set<std::array<std::array<double, 3>, 3>> found;
  for (const auto& t : mesh.triangles) {
    std::array<std::array<double, 3>, 3> corners;
    Vec3 sum = Vec3::Zero();
    double least = radius;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &p = mesh.points[t[k]], &q = mesh.points[t[(k + 1) % 3]];
      corners[k] = {p.x(), p.y(), p.z()};
      sum += p;
      least = std::min(least, 0.5 * (p + q).norm());
    }
    std::sort(corners.begin(), corners.end());
    if (radius - std::min(least, sum.norm() / 3.0) > far) found.insert(corners);
  }
  return found;
}

TEST(BoundaryGuard, TheBoundaryComesNoFartherOffThanItsRoom) {
  const Part part = testing::jittered(testing::ball_part(6), 0.12, 3);
  const double radius = part.mesh.points[part.mesh.triangles[0][0]].norm();
  constexpr double kRoom = 0.012;  // sagittae are estimated: a tenth more is no fault
  const auto before = beyond(part.mesh, radius, 1.1 * kRoom);
  ASSERT_GT(before.size(), 10u);
  ASSERT_LT(before.size(), part.mesh.triangles.size() - 100);
  const auto made = [&](const FinalizeOptions& options) {
    Mesh mesh = part.mesh;
    Observer observer;
    EXPECT_GT(finalize(mesh, part.model, options, observer).smoothed, 50u);
    std::size_t count = 0;
    for (const auto& triangle : beyond(mesh, radius, 1.1 * kRoom)) count += 1 - before.count(triangle);
    return count;
  };
  FinalizeOptions options = testing::options_of_size(0.33);
  EXPECT_GT(made(options), 10u);
  options.room_at = [](const Vec3&) { return kRoom; };
  EXPECT_EQ(made(options), 0u);
}

TEST(BoundaryGuard, BooksWhatOperatorsChange) {
  for (const bool ball : {true, false}) {
    Part part = testing::jittered(ball ? testing::ball_part(6) : testing::cylinder_part(6), 0.12, 3);
    const FinalizeOptions options = testing::options_of_size(0.33);
    Workshop shop(to_work_mesh(part.mesh), part.model, options);
    const double before = shop.guard.area_error();
    Observer observer;
    collapse_short_edges(shop);
    swap_for_mean(shop, 0.2);
    relax_for_mean(shop, 0.2, 1);
    improve_worst_first(shop, 0.6, observer);
    split_long_edges(shop, 0.3);
    EXPECT_GT(shop.report.smoothed * shop.report.edge_removals * shop.report.collapses * shop.report.splits,
              0u);
    EXPECT_GT(std::abs(shop.guard.area_error() - before), 1e-4);
    EXPECT_NEAR(shop.guard.area_error(), BoundaryGuard(part.model, shop.mesh).area_error(), 1e-10);
  }
}

}  // namespace
}  // namespace octet
