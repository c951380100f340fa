// SPDX-License-Identifier: BSD-3-Clause
// Boxes of hierarchies: half the memory of doubles, and all axes are compared at once.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/vec.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace octet {

/// A box of floats. Two that were rounded outward are apart only where what they hold is.
struct FloatBox {
  std::array<float, 3> lo, hi;

  /// Rounded outward.
  [[nodiscard]] static FloatBox around(const Box3& box);

  /// Whether they have no point in common. Most of a traversal is this question: asked of all axes at once it
  /// takes half as long.
  [[nodiscard]] bool apart(const FloatBox& box) const;
  [[nodiscard]] bool apart(const Box3& box) const {
    bool apart = false;
    for (int k = 0; k < 3; ++k) apart |= lo[k] > box.hi[k] || hi[k] < box.lo[k];
    return apart;
  }
  [[nodiscard]] bool holds(const FloatBox& box) const;
  [[nodiscard]] double squared_distance(const Vec3& p) const;
};

/// The greatest float that is no greater than x. In place of the library's nextafter, which takes ten times
/// as long.
[[nodiscard]] inline float round_down(double x) {
  const auto f = static_cast<float>(x);
  if (!(static_cast<double>(f) > x)) return f;
  if (f == 0.0f) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(f) + (f > 0.0f ? -1 : 1));
}

[[nodiscard]] inline float round_up(double x) { return -round_down(-x); }

inline FloatBox FloatBox::around(const Box3& box) {
  FloatBox result;
  for (int k = 0; k < 3; ++k) {
    result.lo[k] = round_down(box.lo[k]);
    result.hi[k] = round_up(box.hi[k]);
  }
  return result;
}

#ifdef __SSE2__
/// Four of a box's six numbers in a register: lo and hi[0], or, from the third on, lo[2] and hi.
[[nodiscard]] inline __m128 four_of(const FloatBox& box, std::size_t from) {
  static_assert(sizeof(FloatBox) == 6 * sizeof(float));
  __m128 numbers;
  std::memcpy(&numbers, reinterpret_cast<const char*>(&box) + from * sizeof(float), sizeof numbers);
  return numbers;
}
#endif

inline bool FloatBox::apart(const FloatBox& box) const {
#ifdef __SSE2__
  const auto lo_of = [](const FloatBox& b) { return four_of(b, 0); };
  const auto hi_of = [](const FloatBox& b) {
    const __m128 last = four_of(b, 2);
    return _mm_shuffle_ps(last, last, _MM_SHUFFLE(0, 3, 2, 1));
  };
  const __m128 beyond =
      _mm_or_ps(_mm_cmpgt_ps(lo_of(*this), hi_of(box)), _mm_cmpgt_ps(lo_of(box), hi_of(*this)));
  constexpr int kAxes = 7;
  return (_mm_movemask_ps(beyond) & kAxes) != 0;
#else
  bool apart = false;
  for (int k = 0; k < 3; ++k) apart |= lo[k] > box.hi[k] || hi[k] < box.lo[k];
  return apart;
#endif
}

inline bool FloatBox::holds(const FloatBox& box) const {
#ifdef __SSE2__
  constexpr int kLow = 7, kHigh = 14;
  const int below = _mm_movemask_ps(_mm_cmpgt_ps(four_of(*this, 0), four_of(box, 0)));
  const int above = _mm_movemask_ps(_mm_cmpgt_ps(four_of(box, 2), four_of(*this, 2)));
  return (below & kLow) == 0 && (above & kHigh) == 0;
#else
  bool holds = true;
  for (int k = 0; k < 3; ++k) holds &= lo[k] <= box.lo[k] && hi[k] >= box.hi[k];
  return holds;
#endif
}

inline double FloatBox::squared_distance(const Vec3& p) const {
#ifdef __SSE2__
  const auto two = [](const float* numbers) {
    return _mm_cvtps_pd(_mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(numbers)));
  };
  const auto outside = [](__m128d low, __m128d high, __m128d at) {
    const __m128d d = _mm_max_pd(_mm_max_pd(_mm_sub_pd(low, at), _mm_sub_pd(at, high)), _mm_setzero_pd());
    return _mm_mul_pd(d, d);
  };
  const __m128d xy = outside(two(lo.data()), two(hi.data()), _mm_loadu_pd(p.data()));
  const __m128d z = outside(_mm_set_sd(lo[2]), _mm_set_sd(hi[2]), _mm_load_sd(p.data() + 2));
  return _mm_cvtsd_f64(_mm_add_sd(_mm_add_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
#else
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double below = static_cast<double>(lo[k]) - p[k], above = p[k] - static_cast<double>(hi[k]);
    const double d = std::max(std::max(below, above), 0.0);
    sum += d * d;
  }
  return sum;
#endif
}

}  // namespace octet
