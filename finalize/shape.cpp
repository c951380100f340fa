// SPDX-License-Identifier: BSD-3-Clause
// The measure that finalization raises: the square of the smallest sine of a tetrahedron's dihedral angles.
#include "finalize/shape.h"

#include <algorithm>
#include <cmath>

namespace octet {

std::array<double, 6> squared_sines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const Vec3 face_d = ab.cross(ac);
  const double det = face_d.dot(ad);
  const double na = bc.cross(bd).squaredNorm(), nb = ac.cross(ad).squaredNorm(),
               nc = ab.cross(ad).squaredNorm(), nd = face_d.squaredNorm();
  if (det == 0.0 || na == 0.0 || nb == 0.0 || nc == 0.0 || nd == 0.0) return {};
  // The sine at an edge e between faces of normals n, m (of twice the areas' length) is 6 V |e| / (|n| |m|).
  const double square = det * std::abs(det);
  const double ia = 1.0 / na, ib = 1.0 / nb, ic = square / nc, id = square / nd;
  return {ab.squaredNorm() * (ic / nd), ac.squaredNorm() * (id * ib), ad.squaredNorm() * (ic * ib),
          bc.squaredNorm() * (id * ia), bd.squaredNorm() * (ic * ia), cd.squaredNorm() * (square * ia * ib)};
}

double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<double, 6> s = squared_sines(a, b, c, d);
  return std::min(std::min(std::min(s[0], s[1]), std::min(s[2], s[3])), std::min(s[4], s[5]));
}

double shape_of_angle(double radians) {
  const double s = std::sin(radians);
  return s * s;
}

}  // namespace octet
