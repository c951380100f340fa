// SPDX-License-Identifier: BSD-3-Clause
// Lists as sets.
#pragma once

#include <algorithm>

namespace octet {

/// In ascending order, and each item once. Cost: O(n log n).
template <class Items>
void sort_unique(Items& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace octet
