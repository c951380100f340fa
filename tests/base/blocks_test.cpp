// SPDX-License-Identifier: BSD-3-Clause
// Loops in parallel blocks give what plain loops give.
#include "base/blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/bucket_sort.h"

namespace octet {
namespace {

TEST(ParallelBlocks, CollectKeepsTheOrderWhateverTheBlock) {
  std::vector<std::size_t> expected;
  const auto visit = [](std::size_t i, std::vector<std::size_t>& items) {
    for (std::size_t k = 0; k < i % 3; ++k) items.push_back(10 * i + k);
  };
  for (std::size_t i = 0; i < 1000; ++i) visit(i, expected);
  for (const std::size_t block : {1, 7, 1000, 5000})
    EXPECT_EQ(collect<std::size_t>(1000, visit, block), expected) << block;
  EXPECT_TRUE(collect<std::size_t>(0, visit).empty());
}

TEST(ParallelBlocks, JoinedListsFollowEachOther) {
  EXPECT_EQ(joined<int>({{1, 2}, {}, {3}, {4, 5, 6}, {}}), (std::vector{1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(joined<int>({}).empty());
}

TEST(RunBoth, RunsTheFirstOnTheCallersThread) {
  std::thread::id here;
  int other = 0;
  run_both([&] { here = std::this_thread::get_id(); }, [&] { other = 1; });
  EXPECT_EQ(here, std::this_thread::get_id());
  EXPECT_EQ(other, 1);
}

TEST(RunBoth, ThrowsWhatOneOfThemThrows) {
  const auto fail = [] { throw std::runtime_error("no"); };
  const auto pass = [] {};
  EXPECT_THROW(run_both(fail, pass), std::runtime_error);
  EXPECT_THROW(run_both(pass, fail), std::runtime_error);
}

/// More buckets than one task has, some of them empty, the first and the last among them.
TEST(BucketSort, SortsByBucketThenByLess) {
  constexpr std::uint32_t kBuckets = 20'000;
  std::vector<std::uint64_t> items(50'000);
  std::uint64_t x = 1;
  for (std::uint64_t& item : items) {
    x = x * 6364136223846793005u + 1442695040888963407u;
    item = (1 + (x >> 33) % (kBuckets - 2)) << 20 | (x >> 13 & 0xfffff);
  }
  std::vector<std::uint64_t> expected = items;
  std::sort(expected.begin(), expected.end());
  for (const Sorting sorting : {Sorting::kOneThread, Sorting::kManyThreads}) {
    std::vector<std::uint64_t> sorted = items;
    bucket_sort(
        sorted, kBuckets, [](std::uint64_t item) { return item >> 20; },
        [](std::uint64_t a, std::uint64_t b) { return a < b; }, sorting);
    EXPECT_EQ(sorted, expected);
  }
  const auto made = bucket_sorted(
      items.size(), kBuckets, [&](std::size_t i) { return items[i]; },
      [](std::uint64_t item) { return item >> 20; }, [](std::uint64_t a, std::uint64_t b) { return a < b; });
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), made.get()));
}

}  // namespace
}  // namespace octet
