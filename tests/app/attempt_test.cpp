// SPDX-License-Identifier: BSD-3-Clause
// What tells that more octants are of no use.
#include "app/attempt.h"

#include <gtest/gtest.h>

namespace octet::test {
namespace {

TEST(Attempt, CrossesAllOverByItsGapsOrByWhatDisagrees) {
  Attempt attempt(Octree{Vec3::Zero(), 1.0, {Octant{}}});
  attempt.surface_points = 200;
  attempt.labels.conflicts.resize(10);
  attempt.closed.gaps.resize(kHopelessGaps);
  EXPECT_FALSE(crosses_all_over(attempt));
  attempt.labels.conflicts.resize(11);
  EXPECT_TRUE(crosses_all_over(attempt));
  attempt.labels.conflicts.clear();
  attempt.closed.gaps.resize(kHopelessGaps + 1);
  EXPECT_TRUE(crosses_all_over(attempt));
}

}  // namespace
}  // namespace octet::test
