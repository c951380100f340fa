// SPDX-License-Identifier: BSD-3-Clause
// A straight piece between two points.
#pragma once

#include <algorithm>

#include "base/vec.h"

namespace octet {

/// Of p from the segment ab; a may be b.
[[nodiscard]] inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double n = d.squaredNorm();
  const double t = n > 0.0 ? std::clamp((p - a).dot(d) / n, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

}  // namespace octet
