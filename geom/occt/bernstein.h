// SPDX-License-Identifier: BSD-3-Clause
// From the Bernstein basis to powers about the middle of the span.
#pragma once

#include <array>

#include "base/vec.h"

namespace octet {

/// Rounding in the power basis grows as 2^degree, of the size of a span: 2e-13 of it for 8 by 3.
inline constexpr int kMaxSpanDegree = 10;

using BernsteinMatrix = std::array<std::array<double, kMaxSpanDegree + 1>, kMaxSpanDegree + 1>;

/// matrix[k][i]: coefficient of s^k in the i-th Bernstein polynomial of this degree at 1/2 + s.
[[nodiscard]] BernsteinMatrix bernstein_to_power(int degree);

/// Value and derivatives of a polynomial by Horner's rule, from the highest coefficient down. `second` holds
/// half of the second derivative.
struct HornerRow {
  Eigen::Vector4d value = Eigen::Vector4d::Zero(), first = Eigen::Vector4d::Zero(),
                  second = Eigen::Vector4d::Zero();
  void push(const Eigen::Vector4d& c, double s, int derivatives) {
    if (derivatives > 1) second = second * s + first;
    if (derivatives > 0) first = first * s + value;
    value = value * s + c;
  }
};

}  // namespace octet
