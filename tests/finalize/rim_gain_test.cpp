// SPDX-License-Identifier: BSD-3-Clause
// The most that the removal of an edge can win is what the better way to fill its rim wins.
#include "finalize/rim_gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "finalize/mean_shape.h"
#include "tests/finalize/builders.h"

namespace octet {
namespace {

/// An edge along z with `count` vertices around it, uneven by chance; open where it lacks its last
/// tetrahedron.
struct Around {
  Around(std::size_t count, bool open, testing::Dice& dice) {
    ring.a = mesh.points.push_back({0.0, 0.0, -0.3 - 0.2 * dice.roll()});
    ring.b = mesh.points.push_back({0.0, 0.0, 0.3 + 0.2 * dice.roll()});
    ring.closed = !open;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.4 * dice.roll()) /
                           static_cast<double>(count + (open ? 1 : 0));
      ring.rim.push_back(mesh.points.push_back({std::cos(angle), std::sin(angle), 0.3 * dice.roll()}));
    }
    ring.tets.resize(open ? count - 1 : count);
  }
  [[nodiscard]] const Vec3& rim(std::size_t i) const { return mesh.points[ring.rim[i % ring.rim.size()]]; }
  [[nodiscard]] double of_edge() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.tets.size(); ++i)
      sum += merit(mesh.points[ring.a], mesh.points[ring.b], rim(i), rim(i + 1));
    return sum;
  }
  /// Of the two tetrahedra on a triangle of the rim.
  [[nodiscard]] double of_pair(std::size_t i, std::size_t j, std::size_t k) const {
    return merit(rim(i), rim(j), rim(k), mesh.points[ring.b]) +
           merit(rim(i), rim(k), rim(j), mesh.points[ring.a]);
  }
  WorkMesh mesh;
  EdgeRing ring;
};

TEST(RimGain, IsThatOfTheBetterWay) {
  testing::Dice dice(3);
  for (int round = 0; round < 50; ++round) {
    for (const bool open : {false, true}) {
      const Around three(3, open, dice), four(4, open, dice);
      EXPECT_NEAR(most_gain_of_removal(three.mesh, three.ring), three.of_pair(0, 1, 2) - three.of_edge(),
                  1e-12);
      const double best = std::max(four.of_pair(0, 1, 2) + four.of_pair(0, 2, 3),
                                   four.of_pair(1, 2, 3) + four.of_pair(0, 1, 3));
      EXPECT_NEAR(most_gain_of_removal(four.mesh, four.ring), best - four.of_edge(), 1e-12);
    }
  }
}

TEST(RimGain, IsNoneWhereWhatWouldBeMadeHasNoVolume) {
  testing::Dice dice(4);
  Around around(3, false, dice);
  for (const VertexId v : around.ring.rim) around.mesh.points[v].z() = 2.0;  // beyond the edge's ends
  EXPECT_LT(most_gain_of_removal(around.mesh, around.ring), -1e300);
}

}  // namespace
}  // namespace octet
