// SPDX-License-Identifier: BSD-3-Clause
// A limit that is used up is not mistaken for none.
#include "geom/occt/time_left.h"

#include <gtest/gtest.h>

namespace octet {
namespace {

TEST(TimeLeft, OfNoLimitThereIsNone) { EXPECT_EQ(TimeLeft(0.0).seconds(), 0.0); }

TEST(TimeLeft, OfALimitThatIsUsedUpAMomentIsLeft) {
  EXPECT_GT(TimeLeft(1e-9).seconds(), 0.0);
  EXPECT_LT(TimeLeft(1e-9).seconds(), 1.0);
}

TEST(TimeLeft, IsNeverMoreThanTheLimit) {
  const TimeLeft time(1000.0);
  EXPECT_LE(time.seconds(), 1000.0);
  EXPECT_GT(time.seconds(), 900.0);
}

TEST(TimeLeft, ARepairGetsAMinuteWhereReadingWasQuick) {
  EXPECT_GT(TimeLeft(300.0).seconds_for_repair(), 50.0);
  EXPECT_LT(TimeLeft(300.0).seconds_for_repair(), 100.0);
  EXPECT_LE(TimeLeft(5.0).seconds_for_repair(), 5.0);
  EXPECT_EQ(TimeLeft(0.0).seconds_for_repair(), 0.0);
}

}  // namespace
}  // namespace octet
