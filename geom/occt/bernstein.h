// SPDX-License-Identifier: BSD-3-Clause
// From the Bernstein basis to powers about the middle of the span.
#pragma once

#include <array>

#include "base/vec.h"

namespace octet {

/// The highest degree that OCCT knows.
inline constexpr int kMaxSpanDegree = 25;

using BernsteinMatrix = std::array<std::array<double, kMaxSpanDegree + 1>, kMaxSpanDegree + 1>;

/// matrix[k][i]: coefficient of s^k in the i-th Bernstein polynomial of this degree at 1/2 + s.
[[nodiscard]] BernsteinMatrix bernstein_to_power(int degree);

/// Homogeneous poles and sums of them, in which the change of basis cancels up to 2.4^degree of their size.
using WidePoint = Eigen::Matrix<long double, 4, 1>;

/// Whether the terms of a sum of powers at the span's ends, `terms` together, are so much larger than the
/// span's poles (`size`) that rounding shows: 2e-13 of the span at most.
[[nodiscard]] inline bool loses_digits(double terms, double size) { return terms > 1000.0 * size; }

/// Value and derivatives of a polynomial by Horner's rule, from the highest coefficient down. `second` holds
/// half of the second derivative, `third` a sixth of the third.
struct HornerRow {
  Eigen::Vector4d value = Eigen::Vector4d::Zero(), first = Eigen::Vector4d::Zero(),
                  second = Eigen::Vector4d::Zero(), third = Eigen::Vector4d::Zero();
  void push(const Eigen::Vector4d& c, double s, int derivatives) {
    if (derivatives > 2) third = third * s + second;
    if (derivatives > 1) second = second * s + first;
    if (derivatives > 0) first = first * s + value;
    value = value * s + c;
  }
};

}  // namespace octet
