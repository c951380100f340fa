// SPDX-License-Identifier: BSD-3-Clause
// The one name of a triangle whatever the order of its corners, and on which side it was seen.
#pragma once

#include <array>
#include <utility>

namespace octet {

/// Sorts the three ascending; true when the permutation was odd, so that the triangle was listed from its
/// other side.
template <class Index>
[[nodiscard]] bool sort_triple(std::array<Index, 3>& v) {
  bool odd = false;
  const auto order = [&](int i, int j) {
    if (v[j] < v[i]) {
      std::swap(v[i], v[j]);
      odd = !odd;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return odd;
}

}  // namespace octet
