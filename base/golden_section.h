// SPDX-License-Identifier: BSD-3-Clause
// The least value of a function with one valley.
#pragma once

#include <numbers>
#include <utility>

namespace octet {

/// Asks value(x) at `cuts` + 2 places of (low, high), each cut leaving 0.618 of the interval; returns the
/// last place that was the lower of two, with its value. A function without a single valley: some low place.
template <class Value>
[[nodiscard]] std::pair<double, double> golden_section(double low, double high, int cuts,
                                                       const Value& value) {
  constexpr double kGolden = std::numbers::phi - 1.0;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = value(a), at_b = value(b);
  for (int i = 0; i < cuts; ++i)
    if (at_a < at_b) {
      high = std::exchange(b, a);
      at_b = at_a;
      at_a = value(a = high - kGolden * (high - low));
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      at_b = value(b = low + kGolden * (high - low));
    }
  return at_a < at_b ? std::pair(a, at_a) : std::pair(b, at_b);
}

}  // namespace octet
