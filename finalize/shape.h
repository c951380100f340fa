// SPDX-License-Identifier: BSD-3-Clause
// The measure that finalization raises: the worst of a tetrahedron's dihedral angles and of its mean ratio.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"

namespace octet {

/// Weight of the cubed mean ratio beside the squared sines: a ratio of 0.5 counts as an angle of 30 degrees.
/// Angles alone let vertices meet: a sliver's angles are best mended by making a needle of it.
inline constexpr double kRatioWeight = 2.0;

/// What makes a tetrahedron good, each with the sign of the volume: the squares of the sines of the six
/// dihedral angles, in the order of kTetEdge (mesh/tet_mesh.h), and kRatioWeight times the cube of the mean
/// ratio. All zero for a tetrahedron without volume.
[[nodiscard]] inline std::array<double, 7> merits_of_shape(const Vec3& a, const Vec3& b, const Vec3& c,
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
  const double lab = ab.squaredNorm(), lac = ac.squaredNorm(), lad = ad.squaredNorm(), lbc = bc.squaredNorm(),
               lbd = bd.squaredNorm(), lcd = cd.squaredNorm();
  // The mean ratio is 12 (3 V)^(2/3) / (sum of squared edges), so its cube is 432 (6 V)^2 / sum^3.
  const double sum = lab + lac + lad + lbc + lbd + lcd;
  return {lab * (ic / nd),
          lac * (id * ib),
          lad * (ic * ib),
          lbc * (id * ia),
          lbd * (ic * ia),
          lcd * (square * ia * ib),
          kRatioWeight * 432.0 * square / (sum * sum * sum)};
}

/// The signed roots of the merits, in the same order, as functions of the last vertex d: their values and
/// gradients there. Roots (sines), not the merits: a square is flat where the tetrahedron is flat. All zero
/// where a face has no area.
struct RootMerits {
  std::array<double, 7> value{};
  std::array<Vec3, 7> gradient{};
};
[[nodiscard]] inline RootMerits root_merits(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const Vec3 face_d = ab.cross(ac);
  const double det = face_d.dot(ad), nd = face_d.squaredNorm();
  const double lab = ab.squaredNorm(), lac = ac.squaredNorm(), lad = ad.squaredNorm(), lbc = bc.squaredNorm(),
               lbd = bd.squaredNorm(), lcd = cd.squaredNorm();
  const double ac_ad = ac.dot(ad), ab_ad = ab.dot(ad), bc_bd = bc.dot(bd);
  const double na = bc.cross(bd).squaredNorm(), nb = ac.cross(ad).squaredNorm(),
               nc = ab.cross(ad).squaredNorm();
  RootMerits roots;
  if (!(na > 0.0 && nb > 0.0 && nc > 0.0 && nd > 0.0)) return roots;
  // Half the gradients of the logarithms of the squared areas and lengths.
  const Vec3 ga = (lbc * bd - bc_bd * bc) / na, gb = (lac * ad - ac_ad * ac) / nb,
             gc = (lab * ad - ab_ad * ab) / nc;
  // The root at an edge e between faces of squared areas n, m is det |e| / sqrt(n m).
  const auto set = [&](int e, double factor, const Vec3& half_log) {
    roots.value[e] = factor * det;
    roots.gradient[e] = factor * (face_d + det * half_log);
  };
  set(0, std::sqrt(lab / (nc * nd)), -gc);
  set(1, std::sqrt(lac / (nd * nb)), -gb);
  set(2, std::sqrt(lad / (nc * nb)), ad / lad - gb - gc);
  set(3, std::sqrt(lbc / (nd * na)), -ga);
  set(4, std::sqrt(lbd / (nc * na)), bd / lbd - ga - gc);
  set(5, std::sqrt(lcd / (na * nb)), cd / lcd - ga - gb);
  const double sum = lab + lac + lad + lbc + lbd + lcd;
  set(6, std::sqrt(kRatioWeight * 432.0 / (sum * sum * sum)), (-3.0 / sum) * (ad + bd + cd));
  return roots;
}

/// The least of the merits, in [0, 8/9]; it falls for angles near 0 and near pi alike, and for needles. Zero
/// or negative when the volume (in doubles) is not positive. Smooth where one alone is the least; no square
/// root, no trigonometry: it is evaluated a hundred times for each tetrahedron made.
[[nodiscard]] inline double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<double, 7> s = merits_of_shape(a, b, c, d);
  return std::min(std::min(std::min(s[0], s[1]), std::min(s[2], s[3])), std::min(std::min(s[4], s[5]), s[6]));
}

/// A tetrahedron of better shape than this is positive by the exact sign, too: its volume is then a
/// thousandth of its edges' cube at least, and rounding moves it by some 1e-15 of that.
inline constexpr double kSurelyPositive = 1e-3;

/// The measure of a tetrahedron whose worst is a dihedral angle of `radians`.
[[nodiscard]] inline double shape_of_angle(double radians) {
  const double s = std::sin(radians);
  return s * s;
}

}  // namespace octet
