// SPDX-License-Identifier: BSD-3-Clause
// The largest angles fall, and nothing gets worse than what they were of.
#include "finalize/improve.h"

#include <gtest/gtest.h>

#include <numbers>

#include "finalize/relax.h"
#include "finalize/schedule.h"
#include "finalize/shape.h"
#include "mesh/quality.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

TEST(Improve, ObtuseAnglesAreOpened) {
  Part part = testing::jittered(testing::cylinder_part(8), 0.05, 3);
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  const FinalizeOptions options = testing::options_of_size(0.25);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  Observer observer;
  improve_worst_first(shop, shape_of_angle(0.5), observer);
  const QualitySummary before = quality_summary(to_mesh(shop.mesh));
  const double limit = before.max_dihedral - 0.1;
  ASSERT_GT(limit, std::numbers::pi / 2) << "none is obtuse";
  shop.forget_failures();
  EXPECT_GT(improve_obtuse(shop, limit, observer).bettered, 0u);
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
  const Mesh mesh = to_mesh(shop.mesh);
  EXPECT_EQ(faults_of(mesh, part.model, euler), "");
  const QualitySummary after = quality_summary(mesh);
  EXPECT_LT(after.max_dihedral, before.max_dihedral);
  EXPECT_GE(after.min_dihedral, std::min(before.min_dihedral, std::numbers::pi - before.max_dihedral));
  EXPECT_EQ(improve_obtuse(shop, std::numbers::pi, observer).bettered, 0u) << "none is beyond";
}

TEST(Improve, SmoothingInVainIsTriedAgainWhereSomethingHasChanged) {
  Part part = testing::jittered(testing::cylinder_part(6), 0.05, 5);
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const double goal = shape_of_angle(0.6);
  const auto work_of_a_sweep = [&] {
    const std::uint64_t before = shop.work;
    relax_around(shop, goal, goal);
    return shop.work - before;
  };
  const std::uint64_t first = work_of_a_sweep();
  int sweeps = 1;
  while (work_of_a_sweep() > 0 && sweeps < 200) ++sweeps;
  ASSERT_LT(sweeps, 200) << "each vertex comes to rest, and costs nothing from then on";
  const auto falls_short = [&](TetId t) { return shop.mesh.alive(t) && shop.mesh.quality[t] < goal; };
  TetId bad(0);
  while (bad.index() < shop.mesh.tets.size() && !falls_short(bad)) bad = TetId(bad.index() + 1);
  ASSERT_LT(bad.index(), shop.mesh.tets.size()) << "none is left to be smoothed in vain";
  shop.made = {bad};
  shop.note_change();
  const std::uint64_t around_a_change = work_of_a_sweep();
  EXPECT_GT(around_a_change, 0u);
  EXPECT_LT(around_a_change, first);
  EXPECT_EQ(work_of_a_sweep(), 0u);
  shop.forget_failures();
  EXPECT_GT(work_of_a_sweep(), around_a_change);
  EXPECT_EQ(work_of_a_sweep(), 0u);
  relax_for_mean(shop, shape_of_angle(0.1), 1);
  EXPECT_GT(work_of_a_sweep(), around_a_change) << "sweeps for the mean do not mark what they move";
}

/// A plate of one layer of elements, `thickness` times as thick as they are wide.
Part plate_of(int cells, double thickness, testing::Dice& dice) {
  Part part = testing::box_part({1, 1, thickness / cells}, cells, cells, 1);
  testing::jitter(part.mesh, part.model, 0.1 / cells, dice);
  return part;
}

TEST(ChaseGoal, IsWhatATenthFallShortOfWhereMostDo) {
  const auto below = [](const WorkMesh& mesh, double goal) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) count += mesh.quality[TetId(i)] < goal ? 1 : 0;
    return count;
  };
  testing::Dice dice(5);
  const double least = shape_of_angle(0.1), goal = shape_of_angle(0.5);
  const WorkMesh many = to_work_mesh(plate_of(100, 0.5, dice).mesh),
                 few = to_work_mesh(plate_of(20, 0.5, dice).mesh);
  ASSERT_GT(below(many, goal), many.tets.size() / 2);
  const double lower = chase_goal(many, least, goal);
  EXPECT_GT(lower, least);
  EXPECT_NEAR(static_cast<double>(below(many, lower)), 0.1 * static_cast<double>(many.tets.size()), 2.0);
  EXPECT_EQ(chase_goal(many, 0.9 * goal, goal), 0.9 * goal);
  ASSERT_GT(below(few, goal), few.tets.size() / 2);
  EXPECT_EQ(chase_goal(few, least, goal), goal) << "so few take no time";
}

TEST(ObtuseLimit, IsWhatATenthAreAboveWhereMostAre) {
  const auto above = [](const WorkMesh& mesh, double limit) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      const TetId t(i);
      const auto at = [&](int corner) { return mesh.point(t, corner); };
      count += dihedral_range(at(0), at(1), at(2), at(3)).largest > limit ? 1 : 0;
    }
    return count;
  };
  testing::Dice dice(5);
  const WorkMesh many = to_work_mesh(plate_of(100, 0.1, dice).mesh),
                 few = to_work_mesh(plate_of(20, 0.1, dice).mesh),
                 thick = to_work_mesh(plate_of(100, 1.0, dice).mesh);
  ASSERT_GT(above(many, kObtuse), many.tets.size() / 5);
  const double limit = obtuse_limit(many);
  EXPECT_GT(limit, kObtuse);
  EXPECT_NEAR(static_cast<double>(above(many, limit)), 0.1 * static_cast<double>(many.tets.size()), 2.0);
  ASSERT_GT(above(few, kObtuse), few.tets.size() / 5);
  EXPECT_EQ(obtuse_limit(few), kObtuse) << "so few take no time";
  EXPECT_EQ(obtuse_limit(thick), kObtuse);
}

TEST(Improve, APassThatBettersFewOfManyIsTheLast) {
  EXPECT_FALSE(is_exhausted({1000, 0})) << "so few take no time";
  EXPECT_TRUE(is_exhausted({10'000, 499}));
  EXPECT_FALSE(is_exhausted({10'000, 500}));
}

TEST(Improve, APassTellsWhatItTriedAndBettered) {
  const Part part = testing::jittered(testing::cylinder_part(6), 0.05, 5);
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const double goal = shape_of_angle(0.8);
  Observer observer;
  const PassResult first = improve_worst_first(shop, goal, observer);
  EXPECT_GT(first.bettered, 0u);
  EXPECT_GT(first.tried, first.bettered);
  const PassResult again = improve_worst_first(shop, goal, observer);
  EXPECT_LT(again.tried, first.tried) << "what failed and has not changed is not tried again";
}

TEST(Schedule, WhereMostElementsAreThinTheTargetAsksForNoMoreWork) {
  testing::Dice dice(7);
  const Part part = plate_of(60, 0.2, dice);
  const auto work_up_to = [&](double target) {
    FinalizeOptions options = testing::options_of_size(1.0 / 60);
    options.scope = FinalizeScope::kFast;
    options.target_dihedral = target;
    Workshop shop(to_work_mesh(part.mesh), part.model, options);
    Observer observer;
    (void)run_schedule(shop, Chosen::kByScope, observer);
    return shop.work;
  };
  EXPECT_EQ(work_up_to(0.349), work_up_to(kThinAngle));
  EXPECT_LT(work_up_to(0.1), work_up_to(kThinAngle)) << "it is what chasing takes";
}

TEST(Schedule, AMeshIsNoWorseForALittleOfItsLeastAngleWhereFewerFallShort) {
  const auto extremes = [](double smallest, std::size_t below) {
    return DihedralExtremes{{smallest, 2.0}, below};
  };
  EXPECT_FALSE(is_worse(extremes(0.2, 3), extremes(0.1, 2)));
  EXPECT_TRUE(is_worse(extremes(0.0999, 3), extremes(0.1, 3)));
  EXPECT_FALSE(is_worse(extremes(0.0999, 2), extremes(0.1, 3)));
  EXPECT_TRUE(is_worse(extremes(0.08, 2), extremes(0.1, 3)));
  EXPECT_FALSE(is_worse(extremes(0.1, 3), extremes(0.1, 3)));
}

}  // namespace
}  // namespace octet
