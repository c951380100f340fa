// SPDX-License-Identifier: BSD-3-Clause
// Long loops in parallel, with results that do not depend on the threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace octet {

/// body(first, last) for blocks of `block` items of [0, n), in parallel; the results in the order of the
/// blocks, whose bounds are the same for any number of threads.
template <class Result, class Body>
[[nodiscard]] std::vector<Result> map_blocks(std::size_t n, std::size_t block, const Body& body) {
  std::vector<Result> results((n + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, results.size(),
                    [&](std::size_t i) { results[i] = body(i * block, std::min(n, (i + 1) * block)); });
  return results;
}

}  // namespace octet
