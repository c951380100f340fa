// SPDX-License-Identifier: BSD-3-Clause
// How many threads a run takes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "base/error.h"

namespace octet {

/// So many as are asked for, but no more than the machine runs at once: they would only wait for each other,
/// and each takes memory. InputError for less than 1.
[[nodiscard]] inline int usable_threads(int asked) {
  if (asked < 1) throw InputError(fmt::format("the number of threads must be at least 1, not {}", asked));
  return std::min(asked, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

}  // namespace octet
