// SPDX-License-Identifier: BSD-3-Clause
// The guard's books of areas: what operators change is in them, and what would make fillets coarser is
// refused.
#include "finalize/boundary_guard.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

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
