// SPDX-License-Identifier: BSD-3-Clause
// The foot of a point on one of OCCT's surfaces, from parameters nearby.
#include "geom/occt/surface_foot.h"

#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "geom/occt/canonical.h"

namespace octet {

SurfaceBounds bounds_of(const Geom_Surface& surface) {
  SurfaceBounds bounds;
  surface.Bounds(bounds.low[0], bounds.high[0], bounds.low[1], bounds.high[1]);
  const std::array<bool, 2> periodic{surface.IsUPeriodic(), surface.IsVPeriodic()};
  for (std::size_t i = 0; i < 2; ++i)
    if (periodic[i]) {
      bounds.low[i] = -Precision::Infinite();
      bounds.high[i] = Precision::Infinite();
    }
  return bounds;
}

Vec2 foot_from(const Geom_Surface& surface, const SurfaceBounds& bounds, const Vec3& point, Vec2 uv) {
  constexpr int kMostSteps = 20;
  constexpr double kFlat = 1e-12, kStill = 1e-14;
  for (int step = 0; step < kMostSteps; ++step) {
    gp_Pnt at;
    gp_Vec du, dv, duu, dvv, duv;
    surface.D2(uv[0], uv[1], at, du, dv, duu, dvv, duv);
    const Vec3 off = to_vec(at) - point;
    const Vec3 u = to_vec(du), v = to_vec(dv);
    const Vec2 slope(off.dot(u), off.dot(v));
    double a = u.squaredNorm() + off.dot(to_vec(duu)), c = v.squaredNorm() + off.dot(to_vec(dvv));
    double b = u.dot(v) + off.dot(to_vec(duv));
    // Where the distance bends the wrong way the tangent plane leads down.
    if (!(a > 0.0 && c > 0.0 && a * c - b * b > kFlat * a * c)) {
      a = u.squaredNorm();
      b = u.dot(v);
      c = v.squaredNorm();
    }
    const double det = a * c - b * b;
    Vec2 move = Vec2::Zero();
    if (det > kFlat * std::max(a, c) * std::max(a, c))
      move = Vec2(b * slope[1] - c * slope[0], b * slope[0] - a * slope[1]) / det;
    else if (a > c)
      move[0] = -slope[0] / a;
    else if (c > 0.0)
      move[1] = -slope[1] / c;
    const Vec2 before = uv;
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(i);
      uv[i] = std::clamp(uv[i] + move[i], bounds.low[k], bounds.high[k]);
    }
    if ((uv - before).norm() <= kStill * (1.0 + uv.norm())) break;
  }
  return uv;
}

}  // namespace octet
