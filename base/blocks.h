// SPDX-License-Identifier: BSD-3-Clause
// Long loops and steps in parallel, with results that do not depend on the threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace octet {

/// Two steps that need nothing of each other, in parallel; `here` on the calling thread. What one of them
/// throws is thrown once both have ended.
template <class Here, class Elsewhere>
void run_both(const Here& here, const Elsewhere& elsewhere) {
  tbb::task_group group;
  group.run(elsewhere);
  group.run_and_wait(here);
}

/// body(first, last) for blocks of `block` items of [0, n), in parallel; the results in the order of the
/// blocks, whose bounds are the same for any number of threads.
template <class Result, class Body>
[[nodiscard]] std::vector<Result> map_blocks(std::size_t n, std::size_t block, const Body& body) {
  std::vector<Result> results((n + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, results.size(),
                    [&](std::size_t i) { results[i] = body(i * block, std::min(n, (i + 1) * block)); });
  return results;
}

/// The lists one after the other, copied in parallel.
template <class Item>
[[nodiscard]] std::vector<Item> joined(const std::vector<std::vector<Item>>& lists) {
  std::vector<std::size_t> begin(lists.size() + 1, 0);
  for (std::size_t b = 0; b < lists.size(); ++b) begin[b + 1] = begin[b] + lists[b].size();
  std::vector<Item> all(begin.back());
  tbb::parallel_for(std::size_t{0}, lists.size(), [&](std::size_t b) {
    std::copy(lists[b].begin(), lists[b].end(), all.begin() + static_cast<std::ptrdiff_t>(begin[b]));
  });
  return all;
}

/// Items looked at by one task where each costs little.
inline constexpr std::size_t kScanBlock = 16384;

/// What visit(i, items) appends to its list for each i of [0, n), joined in the order of i. Blocks in
/// parallel.
template <class Item, class Visit>
[[nodiscard]] std::vector<Item> collect(std::size_t n, const Visit& visit, std::size_t block = kScanBlock) {
  return joined(map_blocks<std::vector<Item>>(n, block, [&](std::size_t first, std::size_t last) {
    std::vector<Item> items;
    for (std::size_t i = first; i < last; ++i) visit(i, items);
    return items;
  }));
}

}  // namespace octet
