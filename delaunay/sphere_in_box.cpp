// SPDX-License-Identifier: BSD-3-Clause
// A filter by the centre in doubles, then exact integers.
#include "delaunay/sphere_in_box.h"

#include <cmath>

#include "base/exact_difference.h"
#include "mesh/circumcentre.h"

namespace octet {
namespace {

// A reliable centre has an error below this share of the radius: its noise margin of 1e4 ulps leaves 2.4e-3
// for the volume and 2e-3 for the numerator (see mesh/circumcentre.cpp).
constexpr double kCentreError = 0.01;

// Whether the sphere lies in x <= bound.x, y <= bound.y, z <= bound.z; with `below` in x >= bound.x, ... .
// In coordinates relative to a, with volume D (six times the tetrahedron's) the centre is n / (2 D), so that
// the condition on x reads |n| <= 2 D bound.x - n.x: no division, no root.
template <int N>
bool within(const Difference<WideInt<N>>& u, const Difference<WideInt<N>>& v, const Difference<WideInt<N>>& w,
            const Difference<WideInt<N>>& bound, bool below) {
  const auto square = [](const Difference<WideInt<N>>& p) { return (p.x * p.x + p.y * p.y) + p.z * p.z; };
  const auto cross = [](const Difference<WideInt<N>>& p, const Difference<WideInt<N>>& q) {
    return Difference<WideInt<2 * N>>{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  };
  const auto vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const auto uu = square(u), vv = square(v), ww = square(w);
  const Difference<WideInt<4 * N>> n{(uu * vw.x + vv * wu.x) + ww * uv.x, (uu * vw.y + vv * wu.y) + ww * uv.y,
                                     (uu * vw.z + vv * wu.z) + ww * uv.z};
  const auto volume = (u.x * vw.x + u.y * vw.y) + u.z * vw.z;
  const auto twice = volume + volume;
  const auto radius2 = (n.x * n.x + n.y * n.y) + n.z * n.z;
  const auto side = [&](const WideInt<N>& b, const WideInt<4 * N>& centre) {
    const auto room = below ? centre - twice * b : twice * b - centre;
    return room.sign() >= 0 && (room * room - radius2).sign() >= 0;
  };
  return side(bound.x, n.x) && side(bound.y, n.y) && side(bound.z, n.z);
}

bool exactly_in_box(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Box3& box) {
  return with_exact_width({&a, &b, &c, &d, &box.lo, &box.hi}, [&]<int N>(WideInt<N>, int lowest) {
    const auto u = exact_minus<N>(b, a, lowest), v = exact_minus<N>(c, a, lowest),
               w = exact_minus<N>(d, a, lowest);
    return within(u, v, w, exact_minus<N>(box.lo, a, lowest), true) &&
           within(u, v, w, exact_minus<N>(box.hi, a, lowest), false);
  });
}

}  // namespace

bool sphere_in_box(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Box3& box) {
  const Circumcentre centre = circumcentre(a, b, c, d);
  if (centre.reliable) {
    const double radius = std::sqrt(centre.squared_radius), error = kCentreError * radius;
    const Vec3 room = (centre.point - box.lo).cwiseMin(box.hi - centre.point);
    if (room.minCoeff() > radius + 2 * error) return true;
    if (room.minCoeff() < radius - 2 * error) return false;
  }
  return exactly_in_box(a, b, c, d, box);
}

}  // namespace octet
