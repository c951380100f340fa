// SPDX-License-Identifier: BSD-3-Clause
// Points, vectors and axis-aligned boxes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

namespace octet {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

[[nodiscard]] inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

/// An axis-aligned box; empty when default-constructed.
struct Box3 {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());

  [[nodiscard]] bool empty() const { return lo.x() > hi.x(); }
  [[nodiscard]] Vec3 size() const { return hi - lo; }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (lo + hi); }
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : size().norm(); }
  [[nodiscard]] bool contains(const Vec3& p) const {
    return (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all();
  }
  [[nodiscard]] bool overlaps(const Box3& b) const {
    return (lo.array() <= b.hi.array()).all() && (b.lo.array() <= hi.array()).all();
  }
  void add(const Vec3& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  void add(const Box3& b) {
    lo = lo.cwiseMin(b.lo);
    hi = hi.cwiseMax(b.hi);
  }
  [[nodiscard]] Box3 grown(double d) const { return {lo - Vec3::Constant(d), hi + Vec3::Constant(d)}; }
  /// Squared distance from `p` to the box, 0 inside.
  [[nodiscard]] double squared_distance(const Vec3& p) const {
    return ((lo - p).cwiseMax(p - hi).cwiseMax(Vec3::Zero())).squaredNorm();
  }
};

}  // namespace octet
