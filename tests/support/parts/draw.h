// SPDX-License-Identifier: BSD-3-Clause
// Draws of a seeded generator: the same numbers with every standard library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace octet::test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15u + 1) {}

  /// In [0, 1).
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * share(); }
  /// As many small as large ones.
  double scaled(double low, double high) { return low * std::pow(high / low, share()); }
  /// A whole number from low to high.
  int count(int low, int high) { return low + static_cast<int>(share() * (high - low + 1)); }
  bool chance(double probability) { return share() < probability; }

  /// A length as drawings have it: mostly a multiple of a tenth, of which coincidences come, sometimes any.
  double length(double low, double high) {
    const double any = between(low, high);
    if (chance(0.2)) return any;
    const double step = std::pow(10.0, std::floor(std::log10(0.5 * high))) / 2.0;
    return std::max(low, std::min(high, step * std::round(any / step)));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace octet::test
