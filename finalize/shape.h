// SPDX-License-Identifier: BSD-3-Clause
// The measure that finalization raises: the square of the smallest sine of a tetrahedron's dihedral angles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"

namespace octet {

/// The squares of the sines of the six dihedral angles, each with the sign of the volume, in the order of
/// kTetEdge (mesh/tet_mesh.h); all zero for a tetrahedron without volume.
[[nodiscard]] inline std::array<double, 6> squared_sines(const Vec3& a, const Vec3& b, const Vec3& c,
                                                         const Vec3& d) {
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

/// Square of the smallest of the six sines, in [0, 8/9]; it falls for angles near 0 and near pi alike. Zero
/// or negative when the volume (in doubles) is not positive. Smooth where one angle alone is the worst; no
/// square root, no trigonometry: it is evaluated a hundred times for each tetrahedron made.
[[nodiscard]] inline double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<double, 6> s = squared_sines(a, b, c, d);
  return std::min(std::min(std::min(s[0], s[1]), std::min(s[2], s[3])), std::min(s[4], s[5]));
}

/// The measure of a tetrahedron whose worst dihedral angle is `radians`.
[[nodiscard]] inline double shape_of_angle(double radians) {
  const double s = std::sin(radians);
  return s * s;
}

}  // namespace octet
