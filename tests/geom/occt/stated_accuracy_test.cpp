// SPDX-License-Identifier: BSD-3-Clause
// A STEP file says how near places are one and the same.
#include <gtest/gtest.h>

#include <string>

#include "geom/occt/document.h"
#include "geom/occt/read_part.h"
#include "tests/support/stated_accuracy.h"

namespace octet::test {
namespace {

TEST(StatedAccuracy, IsReadInMillimetres) {
  const std::string path = testing::TempDir() + "/octet_stated_accuracy.step";
  write_chamfered_block(path, "0.02");
  EXPECT_NEAR(read_document(path, FileKind::kStep).accuracy, 0.02, 1e-12);
  write_chamfered_block(path, "0.02", "INCH");
  EXPECT_NEAR(read_document(path, FileKind::kStep).accuracy, 0.508, 1e-9);
}

TEST(StatedAccuracy, TakesNothingAwayByItself) {
  const std::string path = testing::TempDir() + "/octet_accurate_block.step";
  write_chamfered_block(path, "0.01");
  const Model model = read_part(path);
  EXPECT_EQ(model.count(2), 7);
  EXPECT_NEAR(model.parts().accuracy, 0.01, 1e-12);
}

}  // namespace
}  // namespace octet::test
