// SPDX-License-Identifier: BSD-3-Clause
// No operation of a chase leaves more flat tetrahedra than there were, but for a thousandth of the mesh.
#include "finalize/flat_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "finalize/collapse.h"
#include "finalize/compound.h"
#include "finalize/edge_removal.h"
#include "finalize/face_swap.h"
#include "finalize/shape.h"
#include "finalize/smooth.h"
#include "finalize/split.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::Part;

constexpr double kEightDegrees = 0.1396;

Part jittered_cylinder() { return testing::jittered(testing::cylinder_part(5), 0.2, 5); }

int flat_of(const WorkMesh& mesh) {
  int count = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    count += mesh.alive(TetId(i)) && mesh.quality[TetId(i)] < shape_of_angle(kEightDegrees);
  return count;
}

/// Tries every operator at every tetrahedron, whatever it leaves; the most that the flat ones grew by at
/// once. Each successful operation is told to `see`.
template <class See>
int most_made_by_one(Workshop& shop, const See& see) {
  int most = 0, last = flat_of(shop.mesh);
  const auto tried = [&](bool done) {
    if (!done) return;
    const int now = flat_of(shop.mesh);
    most = std::max(most, now - last);
    last = now;
    see();
  };
  const std::size_t tets = shop.mesh.tets.size();
  for (std::size_t i = 0; i < tets; i += 3) {
    const TetId t(i);
    for (int e = 0; e < 6 && shop.mesh.alive(t); ++e) {
      const auto v = shop.mesh.tets[t];
      const VertexId a = v[kTetEdge[e][0]], b = v[kTetEdge[e][1]];
      tried(remove_edge(shop, t, a, b, kNoise) || collapse_edge(shop, a, b, kNoise) ||
            split_edge(shop, t, a, b, kNoise, 2 * kNoise));
    }
    for (int f = 0; f < 4 && shop.mesh.alive(t); ++f) tried(swap_face(shop, t, f, kNoise));
    if (shop.mesh.alive(t)) tried(smooth_vertex(shop, shop.mesh.tets[t][0], 0.8));
  }
  return most;
}

TEST(FlatGuard, LetsNoOperationLeaveMoreThanThereWere) {
  const Part part = jittered_cylinder();
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop asleep(to_work_mesh(part.mesh), part.model, options);
  int done = 0;
  ASSERT_GT(most_made_by_one(asleep, [&] { ++done; }), 0) << "nothing to be guarded from";
  EXPECT_EQ(asleep.flats.made(), 0u) << "a guard asleep does not count";
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const FlatWatch watch(shop.flats);
  int guarded = 0;
  std::size_t made = 0;
  const int at_first = flat_of(shop.mesh);
  ASSERT_GT(at_first, 10);
  const int most = most_made_by_one(shop, [&] {
    ++guarded;
    made = shop.flats.made();
    ASSERT_LE(static_cast<double>(made), 0.001 * static_cast<double>(shop.mesh.tets.size()));
  });
  EXPECT_GT(guarded, done / 10) << "what leaves no more flat ones is let be";
  EXPECT_LE(most, static_cast<int>(made));
  EXPECT_LE(flat_of(shop.mesh), at_first + static_cast<int>(made));
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
}

TEST(FlatGuard, JudgesATrialAsAWhole) {
  FlatGuard guard;
  constexpr std::size_t kTets = 3000;  // of which three may be made
  const FlatWatch watch(guard);
  EXPECT_TRUE(guard.admits(3, kTets));
  EXPECT_FALSE(guard.admits(4, kTets));
  guard.open_trial();
  EXPECT_TRUE(guard.admits(100, kTets));
  guard.take(100);
  EXPECT_FALSE(guard.settled(kTets));
  guard.take(-98);
  EXPECT_TRUE(guard.settled(kTets));
  guard.keep_trial();
  EXPECT_EQ(guard.made(), 2u);
  EXPECT_TRUE(guard.admits(1, kTets));
  EXPECT_FALSE(guard.admits(2, kTets));
  guard.open_trial();
  guard.take(5);
  guard.take_back_trial();
  EXPECT_EQ(guard.made(), 2u);
  guard.take(-1);
  EXPECT_EQ(guard.made(), 2u) << "what is taken apart gives nothing back";
  EXPECT_TRUE(guard.admits(0, kTets));
}

TEST(FlatGuard, CountsTheShapesOfLessThanEightDegrees) {
  const double just_flat = shape_of_angle(0.99 * kEightDegrees),
               not_flat = shape_of_angle(1.01 * kEightDegrees);
  EXPECT_TRUE(FlatGuard::is_flat(just_flat));
  EXPECT_TRUE(FlatGuard::is_flat(-1.0)) << "turned over by rounding";
  EXPECT_FALSE(FlatGuard::is_flat(not_flat));
  EXPECT_EQ(FlatGuard::count_flat(std::array{just_flat, not_flat, 0.0}), 2);
}

TEST(FlatGuard, HoldsForCompoundMovesToo) {
  const Part part = jittered_cylinder();
  const FinalizeOptions options = testing::options_of_size(0.3);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const FlatWatch watch(shop.flats);
  int done = 0;
  const std::size_t tets = shop.mesh.tets.size();
  for (std::size_t i = 0; i < tets; ++i) {
    if (!shop.mesh.alive(TetId(i)) || shop.mesh.quality[TetId(i)] > 0.2) continue;
    const int before = flat_of(shop.mesh);
    const std::size_t made = shop.flats.made();
    if (!improve_by_compound(shop, TetId(i), 0.4)) {
      EXPECT_EQ(flat_of(shop.mesh), before);
      continue;
    }
    ++done;
    EXPECT_LE(flat_of(shop.mesh), before + static_cast<int>(shop.flats.made() - made));
  }
  EXPECT_GT(done, 10);
  EXPECT_LE(static_cast<double>(shop.flats.made()), 0.001 * static_cast<double>(shop.mesh.tets.size()));
}

}  // namespace
}  // namespace octet
