// SPDX-License-Identifier: BSD-3-Clause
// Numbers that many rooms need, by one name each.
#pragma once

#include <limits>
#include <numbers>

namespace octet {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2.0 * std::numbers::pi;         ///< once around, radians
inline constexpr double kDegree = std::numbers::pi / 180.0;     ///< radians
inline constexpr double kInDegrees = 180.0 / std::numbers::pi;  ///< times an angle in radians
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEps = std::numeric_limits<double>::epsilon();  ///< between 1 and the next number

}  // namespace octet
