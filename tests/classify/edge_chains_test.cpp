// SPDX-License-Identifier: BSD-3-Clause
// Edge chains: found by their ends, in order along the edge, also after splits.
#include <gtest/gtest.h>

#include "classify/band.h"

namespace octet {
namespace {

EdgeChains two_chains() {
  // Edge 1: points 0-1-2 over t 0..2; edge 2: points 2-3 over t 5..6.
  return EdgeChains({{0, 1, 0.0, 1.0, 1}, {1, 2, 1.0, 2.0, 1}, {2, 3, 5.0, 6.0, 2}});
}

TEST(EdgeChains, PiecesAreFoundByTheirEndsInEitherOrder) {
  const EdgeChains chains = two_chains();
  EXPECT_EQ(chains.find(VertexId(1), VertexId(2)), 1u);
  EXPECT_EQ(chains.find(VertexId(2), VertexId(1)), 1u);
  EXPECT_EQ(chains.find(VertexId(0), VertexId(2)), UINT32_MAX);
}

TEST(EdgeChains, PieceAtHoldsTheParameter) {
  const EdgeChains chains = two_chains();
  EXPECT_EQ(chains.piece_at(1, 0.3), 0u);
  EXPECT_EQ(chains.piece_at(1, 1.7), 1u);
  EXPECT_EQ(chains.piece_at(2, 5.5), 2u);
}

TEST(EdgeChains, ASplitReplacesOnePieceByTwoThatMeetInThePoint) {
  EdgeChains chains = two_chains();
  chains.split(0, VertexId(9), 0.25);
  EXPECT_EQ(chains.find(VertexId(0), VertexId(1)), UINT32_MAX);
  const std::uint32_t first = chains.find(VertexId(0), VertexId(9)), second = chains.find(VertexId(9), VertexId(1));
  ASSERT_NE(first, UINT32_MAX);
  ASSERT_NE(second, UINT32_MAX);
  EXPECT_EQ(chains[first].tb, 0.25);
  EXPECT_EQ(chains[second].ta, 0.25);
  EXPECT_EQ(chains.piece_at(1, 0.1), first);
  EXPECT_EQ(chains.piece_at(1, 0.9), second);
  EXPECT_EQ(chains.piece_at(1, 1.5), 1u);
}

}  // namespace
}  // namespace octet
