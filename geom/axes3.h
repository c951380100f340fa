// SPDX-License-Identifier: BSD-3-Clause
// An orthonormal frame, right- or left-handed, and angles kept in a period.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vec.h"

namespace octet {

/// Origin and three orthonormal axes. Left-handed frames occur in CAD files and are allowed.
struct Axes3 {
  Vec3 origin = Vec3::Zero();
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

  [[nodiscard]] Vec3 to_local(const Vec3& p) const { return direction_to_local(p - origin); }
  [[nodiscard]] Vec3 direction_to_local(const Vec3& d) const { return {d.dot(x), d.dot(y), d.dot(z)}; }
  [[nodiscard]] Vec3 to_world(const Vec3& l) const { return origin + direction_to_world(l); }
  [[nodiscard]] Vec3 direction_to_world(const Vec3& l) const { return l.x() * x + l.y() * y + l.z() * z; }
  /// +1 right-handed, -1 left-handed.
  [[nodiscard]] double handedness() const { return x.cross(y).dot(z) < 0.0 ? -1.0 : 1.0; }
};

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// `angle` moved by whole turns into [start, start + 2 pi).
[[nodiscard]] inline double wrap_angle(double angle, double start) {
  double a = angle - kTwoPi * std::floor((angle - start) / kTwoPi);
  if (a < start) a = start;
  return a >= start + kTwoPi ? start : a;
}

/// Like wrap_angle(), but at the period's ends the one near `seed` is taken.
[[nodiscard]] inline double wrap_angle_near(double angle, double start, double seed) {
  constexpr double kNear = 1e-9;
  const double a = wrap_angle(angle, start);
  if (a - start < kNear && seed - start > std::numbers::pi) return start + kTwoPi;
  if (start + kTwoPi - a < kNear && seed - start < std::numbers::pi) return start;
  return a;
}

}  // namespace octet
