// SPDX-License-Identifier: BSD-3-Clause
// The order of octree vertices.
#include "base/vertex_order.h"

#include <gtest/gtest.h>

#include <set>

namespace octet {
namespace {

constexpr std::uint32_t kRoot = 1u << kLatticeLevels;

std::uint64_t class_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return octree_vertex_rank(i, j, k) >> kRankClassShift;
}

TEST(VertexOrder, OddCornersOutweighTheOthersEquallyInEveryOctant) {
  for (int level = 1; level <= kLatticeLevels; ++level) {
    const std::uint32_t e = kRoot >> level, n = 1u << level;
    for (std::uint32_t at : {0u, n / 2, n - 1}) {
      std::set<std::uint64_t> odd, even;
      for (std::uint32_t c = 0; c < 8; ++c) {
        const std::uint32_t i = at + (c & 1), j = (n - 1 - at) + (c >> 1 & 1), k = at + (c >> 2);
        (((i + j + k) & 1) != 0 ? odd : even).insert(class_of(i * e, j * e, k * e));
      }
      ASSERT_EQ(odd.size(), 1u);
      ASSERT_GT(*odd.begin(), *even.rbegin());
    }
  }
}

TEST(VertexOrder, RanksAreDistinctAndAboveFreePoints) {
  std::set<std::uint64_t> ranks;
  const std::uint32_t e = kRoot / 8;
  for (std::uint32_t i = 0; i <= 8; ++i) {
    for (std::uint32_t j = 0; j <= 8; ++j) {
      for (std::uint32_t k = 0; k <= 8; ++k) ranks.insert(octree_vertex_rank(i * e, j * e, k * e));
    }
  }
  EXPECT_EQ(ranks.size(), 729u);
  EXPECT_GT(*ranks.begin(), free_point_rank(~std::uint64_t{0} >> 1));
}

TEST(VertexOrder, FinerVerticesOutweighCoarserOnes) {
  const std::uint32_t e = kRoot >> 3;
  EXPECT_GT(class_of(e, e, 0), class_of(2 * e, 0, 0));
  EXPECT_GT(class_of(2 * e, 0, 0), class_of(2 * e, 2 * e, 0));
}

}  // namespace
}  // namespace octet
