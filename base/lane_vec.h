// SPDX-License-Identifier: BSD-3-Clause
// Vectors of lanes: the geometry of four at once.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "base/wide_clones.h"

namespace octet {

/// Four vectors, one a lane. The operations are those of Vec3 in the same order, so a lane has the bits that
/// a Vec3 would have.
struct LaneVec3 {
  Lanes row[3];
  [[nodiscard]] Lanes& operator[](std::size_t i) { return row[i]; }
  [[nodiscard]] const Lanes& operator[](std::size_t i) const { return row[i]; }

  OCTET_LANEWISE void set(std::size_t lane, const Vec3& p) {
    for (int i = 0; i < 3; ++i) row[i][lane] = p[i];
  }
};

OCTET_LANEWISE LaneVec3 operator-(const LaneVec3& p, const LaneVec3& q) {
  return {{p[0] - q[0], p[1] - q[1], p[2] - q[2]}};
}
/// From four points to one.
OCTET_LANEWISE LaneVec3 operator-(const Vec3& p, const LaneVec3& q) {
  return {{p.x() - q[0], p.y() - q[1], p.z() - q[2]}};
}
OCTET_LANEWISE Lanes dot(const LaneVec3& p, const LaneVec3& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
OCTET_LANEWISE LaneVec3 cross(const LaneVec3& p, const LaneVec3& q) {
  return {{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}};
}
OCTET_LANEWISE double dot(const Vec3& p, const Vec3& q) { return p.dot(q); }
OCTET_LANEWISE Vec3 cross(const Vec3& p, const Vec3& q) { return p.cross(q); }

/// For files that are compiled without a look at errno, which the processor's own roots do not set.
OCTET_LANEWISE Lanes root(const Lanes& p) {
  return Lanes{std::sqrt(p[0]), std::sqrt(p[1]), std::sqrt(p[2]), std::sqrt(p[3])};
}

/// The same for a number and for lanes of numbers.
template <class Real>
OCTET_LANEWISE Real least(const Real& p, const Real& q) {
  return p < q ? p : q;
}
template <class Real>
OCTET_LANEWISE Real most(const Real& p, const Real& q) {
  return p < q ? q : p;
}
template <class Real>
OCTET_LANEWISE Real magnitude(const Real& p) {
  return p < 0.0 ? -p : p;
}

}  // namespace octet
