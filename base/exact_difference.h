// SPDX-License-Identifier: BSD-3-Clause
// Differences of points as integers, exactly: the door from doubles to WideInt.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "base/vec.h"
#include "base/wide_int.h"

namespace octet {

/// One point minus another; T is double or a WideInt.
template <class T>
struct Difference {
  T x, y, z;
};

/// Exponent of the lowest bit that is set in any coordinate; INT_MAX when all are zero.
[[nodiscard]] inline int lowest_exponent(std::initializer_list<const Vec3*> points) {
  int lowest = std::numeric_limits<int>::max();
  for (const Vec3* p : points) {
    for (int k = 0; k < 3; ++k) {
      const auto bits = std::bit_cast<std::uint64_t>((*p)[k]);
      const int biased = static_cast<int>((bits >> 52) & 0x7ff);
      std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
      if (biased != 0) mantissa |= std::uint64_t{1} << 52;
      if (mantissa == 0) continue;
      lowest = std::min(lowest, (biased == 0 ? 1 : biased) - 1075 + std::countr_zero(mantissa));
    }
  }
  return lowest;
}

/// Calls f(WideInt<N>(), lowest), where the differences of any two of the points, in units of 2^lowest, have
/// at most 64 N - 2 bits. Requires: not all coordinates are zero.
template <class F>
auto with_exact_width(std::initializer_list<const Vec3*> points, const F& f) {
  double reach = 0;
  const Vec3& first = **points.begin();
  for (const Vec3* p : points) {
    for (int k = 0; k < 3; ++k) reach = std::max(reach, std::abs((*p)[k] - first[k]));
  }
  const int lowest = lowest_exponent(points);
  // Differences to the first point are at most `reach`, rounded; any others twice that.
  const int top = reach == 0 ? lowest : std::isfinite(reach) ? std::ilogb(reach) + 2 : 1026;
  const int bits = top - lowest;
  if (bits <= 62) return f(WideInt<1>(), lowest);
  if (bits <= 126) return f(WideInt<2>(), lowest);
  if (bits <= 318) return f(WideInt<5>(), lowest);
  return f(WideInt<33>(), lowest);
}

/// A point in units of 2^lowest, modulo 2^(64 N): differences of two of them are exact for the N that
/// with_exact_width() chose.
template <int N>
[[nodiscard]] Difference<WideInt<N>> exact(const Vec3& p, int lowest) {
  using W = WideInt<N>;
  return {W::from_scaled(p.x(), lowest), W::from_scaled(p.y(), lowest), W::from_scaled(p.z(), lowest)};
}

template <class T>
[[nodiscard]] Difference<T> operator-(const Difference<T>& a, const Difference<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a - b in units of 2^lowest.
template <int N>
[[nodiscard]] Difference<WideInt<N>> exact_minus(const Vec3& a, const Vec3& b, int lowest) {
  return exact<N>(a, lowest) - exact<N>(b, lowest);
}

}  // namespace octet
