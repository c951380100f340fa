// SPDX-License-Identifier: BSD-3-Clause
// What is taken back leaves no trace, and compound moves better what they touch or change nothing.
#include "finalize/compound.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "finalize/collapse.h"
#include "finalize/edge_removal.h"
#include "finalize/smooth.h"
#include "finalize/split.h"
#include "finalize/trial.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::Part;

Part jittered_cylinder() { return testing::jittered(testing::cylinder_part(5), 0.12, 5); }

/// All that a trial has to bring back.
struct State {
  explicit State(const Workshop& shop)
      : mesh(shop.mesh), smoothed(shop.report.smoothed), area_error(shop.guard.area_error()) {
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const VertexId v(i);
      if (mesh.on[v].dim == 1) parameters.push_back(shop.guard.parameter(v));
      if (mesh.on[v].dim == 2) seats.push_back(shop.guard.seat(mesh, v, mesh.on[v].tag).normal);
    }
  }
  WorkMesh mesh;
  std::size_t smoothed;
  double area_error;
  std::vector<double> parameters;
  std::vector<Vec3> seats;
};

void expect_same(const State& p, const State& q) {
  EXPECT_EQ(p.mesh.points.values(), q.mesh.points.values());
  EXPECT_EQ(p.mesh.tet_of.values(), q.mesh.tet_of.values());
  EXPECT_EQ(p.mesh.tets.values(), q.mesh.tets.values());
  EXPECT_EQ(p.mesh.neighbours.values(), q.mesh.neighbours.values());
  EXPECT_EQ(p.mesh.face_on.values(), q.mesh.face_on.values());
  EXPECT_EQ(p.mesh.quality.values(), q.mesh.quality.values());
  EXPECT_EQ(p.mesh.free_tets, q.mesh.free_tets);
  EXPECT_EQ(p.mesh.pieces, q.mesh.pieces);
  EXPECT_EQ(p.mesh.pieces_on_edge, q.mesh.pieces_on_edge);
  EXPECT_EQ(p.parameters, q.parameters);
  EXPECT_EQ(p.seats, q.seats);
  EXPECT_EQ(p.smoothed, q.smoothed);
  EXPECT_EQ(p.area_error, q.area_error);
}

/// One operation of each kind at t, whatever comes of it.
std::size_t operate(Workshop& shop, TetId t) {
  std::size_t done = 0;
  const auto edge = [&](int e) {
    const auto& v = shop.mesh.tets[t];
    return std::pair(v[kTetEdge[e][0]], v[kTetEdge[e][1]]);
  };
  for (int e = 0; e < 6 && shop.mesh.alive(t); ++e)
    done += split_edge(shop, t, edge(e).first, edge(e).second, kNoise, 0.5);
  for (int e = 0; e < 6 && shop.mesh.alive(t); ++e)
    done += remove_edge(shop, t, edge(e).first, edge(e).second, kNoise);
  for (int e = 0; e < 6 && shop.mesh.alive(t); ++e)
    done += collapse_edge(shop, edge(e).first, edge(e).second, kNoise);
  for (std::size_t v = 0; v < shop.mesh.points.size(); v += 7)
    done += shop.mesh.alive(VertexId(v)) && smooth_vertex(shop, VertexId(v), 0.8);
  return done;
}

TEST(Trial, TakesEverythingBackUnlessItIsKept) {
  const Part part = jittered_cylinder();
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  std::size_t done = 0;
  for (std::size_t i = 0; i < 200; i += 10) {
    const State before(shop);
    {
      Trial trial(shop);
      done += operate(shop, TetId(i));
    }
    ASSERT_EQ(check_work_mesh(shop.mesh), "");
    expect_same(before, State(shop));
  }
  EXPECT_GT(done, 200u);
  Trial trial(shop);
  ASSERT_GT(operate(shop, TetId(0)), 0u);
  trial.keep();
  EXPECT_NE(to_mesh(shop.mesh).points, part.mesh.points);
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
}

TEST(Compound, BettersAllThatItTouchesOrChangesNothing) {
  constexpr double kGoal = 0.4;
  const Part part = jittered_cylinder();
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  int better = 0, given_up = 0;
  const std::size_t tets = shop.mesh.tets.size();
  for (std::size_t i = 0; i < tets; i += 5) {
    const TetId t(i);
    if (!shop.mesh.alive(t) || shop.mesh.quality[t] > kGoal) continue;
    const double before = shop.mesh.quality[t];
    const State state(shop);
    if (!improve_by_compound(shop, t, kGoal)) {
      ++given_up;
      expect_same(state, State(shop));
      continue;
    }
    ++better;
    ASSERT_FALSE(shop.made.empty());
    for (const TetId made : shop.made) EXPECT_GT(shop.mesh.quality[made], before);
  }
  EXPECT_GT(better, 20);
  EXPECT_GT(given_up, 0);
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
  EXPECT_EQ(testing::faults_of(to_mesh(shop.mesh), part.model, euler), "");
}

TEST(Compound, EndsWhenItsShareOfTheWorkIsSpent) {
  constexpr double kGoal = 0.4;
  const Part part = jittered_cylinder();
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop first(to_work_mesh(part.mesh), part.model, options);
  TetId improved;  // what fails before changes nothing
  for (std::size_t i = 0; i < part.mesh.tets.size() && !improved.valid(); ++i) {
    const TetId t(i);
    if (first.mesh.quality[t] <= kGoal && improve_by_compound(first, t, kGoal)) improved = t;
    EXPECT_EQ(first.compound_work, first.work);
  }
  ASSERT_TRUE(improved.valid());
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const State state(shop);
  constexpr std::uint64_t kSpent = 30'000'000;
  shop.compound_work = kSpent;
  EXPECT_FALSE(improve_by_compound(shop, improved, kGoal));
  EXPECT_EQ(shop.compound_work, kSpent);
  expect_same(state, State(shop));
  shop.compound_work = 0;
  EXPECT_TRUE(improve_by_compound(shop, improved, kGoal));
  EXPECT_EQ(shop.compound_kept, 1u);
}

TEST(Compound, EndsWhereTooFewAreKept) {
  constexpr double kGoal = 0.4;
  constexpr std::uint64_t kSpent = 6'000'000;
  const Part part = jittered_cylinder();
  const FinalizeOptions options = testing::options_of_size(0.3);
  const auto improves = [&](std::uint64_t kept) {
    Workshop shop(to_work_mesh(part.mesh), part.model, options);
    for (std::size_t i = 0; i < part.mesh.tets.size(); ++i) {
      shop.compound_work = kSpent;
      shop.compound_kept = kept;
      if (shop.mesh.quality[TetId(i)] <= kGoal && improve_by_compound(shop, TetId(i), kGoal)) return true;
    }
    return false;
  };
  EXPECT_FALSE(improves(10)) << "200 000 evaluations for one";
  EXPECT_TRUE(improves(1000));
}

}  // namespace
}  // namespace octet
