// SPDX-License-Identifier: BSD-3-Clause
// A STEP file says how near places are one and the same.
#include <gtest/gtest.h>

#include "geom/occt/document.h"
#include "geom/occt/read_part.h"
#include "tests/support/chamfered_block.h"

namespace octet::test {
namespace {

TEST(StatedAccuracy, IsReadInMillimetres) {
  EXPECT_NEAR(read_document(ChamferedBlock("0.02").path(), FileKind::kStep).accuracy, 0.02, 1e-12);
  EXPECT_NEAR(read_document(ChamferedBlock("0.02", "INCH").path(), FileKind::kStep).accuracy, 0.508, 1e-9);
}

TEST(StatedAccuracy, TakesNothingAwayByItself) {
  const ChamferedBlock block("0.01");
  const Model model = read_part(block.path());
  EXPECT_EQ(model.count(2), 7);
  EXPECT_NEAR(model.parts().accuracy, 0.01, 1e-12);
}

}  // namespace
}  // namespace octet::test
