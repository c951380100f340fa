// SPDX-License-Identifier: BSD-3-Clause
// The centre of the sphere through four points, with a verdict on its own noise.
#include "mesh/circumcentre.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace octet {
namespace {

// The volume must exceed what moving each coordinate by an ulp changes, by this factor; the centre then has
// at least two digits, mostly four. Measured: points rounded onto oblique planes reach 2 ulps.
constexpr double kNoiseMargin = 1e4;

}  // namespace

Circumcentre circumcentre(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  const Vec3 vw = v.cross(w), wu = w.cross(u), uv = u.cross(v);
  const double volume = u.dot(vw);  // six times the tetrahedron's
  const double reach = std::max(
      {a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff(), d.cwiseAbs().maxCoeff()});
  const double longest2 = std::max({uu, vv, ww});
  const double noise =
      std::numeric_limits<double>::epsilon() * std::max(reach, std::sqrt(longest2)) * longest2;

  Circumcentre centre;
  centre.reliable = std::abs(volume) > kNoiseMargin * noise;
  if (volume == 0) {
    centre.point = 0.25 * (a + b + c + d);
    centre.squared_radius = std::numeric_limits<double>::infinity();
    return centre;
  }
  const Vec3 offset = (uu * vw + vv * wu + ww * uv) / (2 * volume);
  centre.point = a + offset;
  centre.squared_radius = offset.squaredNorm();
  return centre;
}

}  // namespace octet
