// SPDX-License-Identifier: BSD-3-Clause
// Progress of work that begins anew.
#include "base/onward.h"

#include <gtest/gtest.h>

namespace octet {
namespace {

TEST(Onward, IsWhatComesWhereNothingBeginsAnew) {
  Onward onward;
  for (const double fraction : {0.0, 0.1, 0.1, 0.45, 0.9, 1.0}) EXPECT_EQ(onward(fraction), fraction);
}

TEST(Onward, AnotherTryGoesThroughWhatIsLeft) {
  Onward onward;
  EXPECT_EQ(onward(0.6), 0.6);
  EXPECT_EQ(onward(0.0), 0.6);
  EXPECT_NEAR(onward(0.5), 0.8, 1e-12);
  EXPECT_NEAR(onward(0.25), 0.85, 1e-12);
  EXPECT_NEAR(onward(1.0), 1.0, 1e-12);
}

TEST(Onward, NeverGoesBackNorBeyondTheEnd) {
  Onward onward;
  double last = 0.0;
  for (const double fraction : {0.3, 0.9, 0.1, 2.0, 0.0, -1.0, 0.7, 1.0}) {
    const double told = onward(fraction);
    EXPECT_GE(told, last);
    EXPECT_LE(told, 1.0);
    last = told;
  }
}

}  // namespace
}  // namespace octet
