// SPDX-License-Identifier: BSD-3-Clause
// The least value is closed in on, wherever it lies.
#include "base/golden_section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octet {
namespace {

TEST(GoldenSection, ClosesInOnTheLeastValue) {
  for (const double at : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    int asked = 0;
    const auto [x, value] = golden_section(0.0, 1.0, 20, [&](double s) {
      ++asked;
      return 3.0 + std::abs(s - at);
    });
    EXPECT_NEAR(x, at, std::pow(0.6181, 20));
    EXPECT_EQ(value, 3.0 + std::abs(x - at));
    EXPECT_EQ(asked, 22);
  }
}

}  // namespace
}  // namespace octet
