// SPDX-License-Identifier: BSD-3-Clause
// The map from numbers as read to tags, and back.
#include "geom/provenance.h"

#include <gtest/gtest.h>

namespace octet {
namespace {

/// Solid 1 became regions 1 and 3, solid 2 became 2 and 3, solid 3 went.
Provenance two_that_overlap() {
  Provenance provenance;
  provenance.as_read[3] = {{}, {"a", {1, 3}}, {"b", {2, 3}}, {"c", {}}};
  return provenance;
}

TEST(Provenance, SourcesTurnTheMapRound) {
  const std::vector<std::vector<int>> expected{{}, {1}, {2}, {1, 2}, {}};
  EXPECT_EQ(sources(two_that_overlap(), 3, 4), expected);
}

TEST(Provenance, AnOverlapIsARegionOfSeveralSolids) {
  const auto found = overlaps(two_that_overlap(), 4);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].region, 3);
  EXPECT_EQ(found[0].solids, (std::vector<int>{1, 2}));
}

TEST(Provenance, AModelOfNoFileHasNone) { EXPECT_TRUE(overlaps(Provenance(), 2).empty()); }

}  // namespace
}  // namespace octet
