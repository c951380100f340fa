// SPDX-License-Identifier: BSD-3-Clause
// The table of units.
#include "app/length_unit.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace octet {
namespace {

TEST(LengthUnit, FactorsAreExact) {
  EXPECT_EQ(length_unit("mm").millimetres, 1.0);
  EXPECT_EQ(length_unit("um").millimetres, 0.001);
  EXPECT_EQ(length_unit("cm").millimetres, 10.0);
  EXPECT_EQ(length_unit("m").millimetres, 1000.0);
  EXPECT_EQ(length_unit("inch").millimetres, 25.4);
  EXPECT_DOUBLE_EQ(length_unit("ft").millimetres, 12 * length_unit("in").millimetres);
  EXPECT_DOUBLE_EQ(length_unit("yd").millimetres, 3 * length_unit("ft").millimetres);
}

TEST(LengthUnit, NamesAreReadInAnyCaseAndNumber) {
  EXPECT_EQ(length_unit("Inches").name, "inch");
  EXPECT_EQ(length_unit("METRE").name, "metre");
  EXPECT_EQ(length_unit("meters").name, "metre");
}

TEST(LengthUnit, UnknownNameIsAnInputError) {
  EXPECT_THROW(static_cast<void>(length_unit("parsec")), InputError);
  EXPECT_THROW(static_cast<void>(length_unit("")), InputError);
}

}  // namespace
}  // namespace octet
