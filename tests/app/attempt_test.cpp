// SPDX-License-Identifier: BSD-3-Clause
// What tells that more octants are of no use.
#include "app/attempt.h"

#include <gtest/gtest.h>

#include <vector>

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

TEST(Attempt, IsMoreOpenWhereEdgesLackPiecesThanWithAnyNumberOfOtherGaps) {
  std::vector<Gap> one_piece(1), fans(500);
  one_piece[0].kind = GapKind::kMissingPiece;
  for (Gap& gap : fans) gap.kind = GapKind::kBareFace;
  EXPECT_LT(openness(fans), openness(one_piece));
  EXPECT_TRUE(clearly_less(openness(fans), openness(one_piece)));
  EXPECT_FALSE(clearly_less(openness(one_piece), openness(fans)));
}

TEST(Attempt, IsClearlyLessOpenWithATenthFewerGaps) {
  EXPECT_TRUE(clearly_less({false, 89}, {false, 100}));
  EXPECT_FALSE(clearly_less({false, 90}, {false, 100}));
  EXPECT_FALSE(clearly_less({true, 1491}, {true, 1582}));
  EXPECT_FALSE(clearly_less({false, 0}, {false, 0}));
}

}  // namespace
}  // namespace octet::test
