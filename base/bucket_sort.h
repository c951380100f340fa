// SPDX-License-Identifier: BSD-3-Clause
// Sorting by a number that has about as many values as there are items.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace octet {

/// Who sorts the buckets.
enum class Sorting { kOneThread, kManyThreads };

/// Sorts by bucket_of(item), in 0..buckets-1, then by `less`. O(n + buckets) where all buckets are small.
/// Requires fewer than 2^32 items.
template <class Item, class BucketOf, class Less>
void bucket_sort(std::vector<Item>& items, std::size_t buckets, const BucketOf& bucket_of, const Less& less,
                 Sorting sorting = Sorting::kManyThreads) {
  std::vector<std::uint32_t> end(buckets + 1, 0);
  for (const Item& item : items) ++end[bucket_of(item) + 1];
  for (std::size_t b = 0; b < buckets; ++b) end[b + 1] += end[b];
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[end[bucket_of(item)]++] = item;
  const tbb::blocked_range<std::size_t> all(0, buckets, 4096);
  const auto sort_buckets = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b)
      std::sort(sorted.begin() + (b == 0 ? 0 : end[b - 1]), sorted.begin() + end[b], less);
  };
  if (sorting == Sorting::kOneThread)
    sort_buckets(all);
  else
    tbb::parallel_for(all, sort_buckets);
  items.swap(sorted);
}

/// The items make(i), i < count, in that order, by all threads; each is made twice, so that none but the
/// result is kept. Requires `less` to tell any two items of a bucket apart: threads put them there in any
/// order.
template <class Make, class BucketOf, class Less>
[[nodiscard]] auto bucket_sorted(std::size_t count, std::size_t buckets, const Make& make,
                                 const BucketOf& bucket_of, const Less& less) {
  using Item = std::decay_t<decltype(make(std::size_t{0}))>;
  std::vector<std::uint32_t> end(buckets + 1, 0);
  const auto next = [&end](std::size_t place) {
    return std::atomic_ref(end[place]).fetch_add(1, std::memory_order_relaxed);
  };
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { next(bucket_of(make(i)) + 1); });
  for (std::size_t b = 0; b < buckets; ++b) end[b + 1] += end[b];
  auto sorted = std::make_unique_for_overwrite<Item[]>(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const Item item = make(i);
    sorted[next(bucket_of(item))] = item;
  });
  tbb::parallel_for(std::size_t{0}, buckets, [&](std::size_t b) {
    std::sort(sorted.get() + (b == 0 ? 0 : end[b - 1]), sorted.get() + end[b], less);
  });
  return sorted;
}

}  // namespace octet
