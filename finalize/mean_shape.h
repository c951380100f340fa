// SPDX-License-Identifier: BSD-3-Clause
// The measure whose sum over a star smoothing for the mean lowers: a convex function of each vertex.
#pragma once

#include <cmath>
#include <limits>

#include "base/vec.h"

namespace octet {

using Mat3 = Eigen::Matrix3d;

/// The mean ratio to the power -3/2, as a function of the vertex at p over the base (x, y, z): 1 for the
/// regular tetrahedron, infinite for one without volume. Convex in p where the volume is positive (it is
/// |q|^3 / v with q affine and v linear in p), so that Newton's method finds the one minimum of a star.
struct Distortion {
  double value = 0.0;
  Vec3 gradient = Vec3::Zero();
  Mat3 hessian = Mat3::Zero();  ///< upper triangle
};

/// 6 V over (sum of squared edges)^(3/2) of the regular tetrahedron: 1 / (12 sqrt 3).
inline constexpr double kDistortionUnit = 0.04811252243246881;

/// The distortion alone.
[[nodiscard]] inline double distortion(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& p) {
  const Vec3 xy = y - x, xz = z - x, yz = z - y;
  const double volume = xy.cross(xz).dot(p - x);
  if (!(volume > 0.0)) return std::numeric_limits<double>::infinity();
  const double squares = xy.squaredNorm() + xz.squaredNorm() + yz.squaredNorm() + (p - x).squaredNorm() +
                         (p - y).squaredNorm() + (p - z).squaredNorm();
  return kDistortionUnit * squares * std::sqrt(squares) / volume;
}

/// What a tetrahedron adds to the mean: how far its distortion is below an ordinary one's. A change that
/// raises the sum raises the mean also where the number of tetrahedra changes.
inline constexpr double kOrdinaryDistortion = 1.25;
inline constexpr double kMeritOfPerfect = kOrdinaryDistortion - 1.0;
[[nodiscard]] inline double merit(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return kOrdinaryDistortion - distortion(a, b, c, d);
}

/// Adds value, gradient and Hessian; false, and nothing added, without volume.
[[nodiscard]] inline bool add_distortion(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& p,
                                         Distortion& sum) {
  const Vec3 xy = y - x, xz = z - x, to_x = p - x, to_y = p - y, to_z = p - z;
  const Vec3 normal = xy.cross(xz);
  const double volume = normal.dot(to_x);
  if (!(volume > 0.0)) return false;
  const double squares = xy.squaredNorm() + xz.squaredNorm() + (z - y).squaredNorm() + to_x.squaredNorm() +
                         to_y.squaredNorm() + to_z.squaredNorm();
  const double value = kDistortionUnit * squares * std::sqrt(squares) / volume;
  // With s the squares and v the volume, the derivatives of the logarithm are 1.5 s'/s - v'/v.
  const double over_squares = 1.0 / squares;
  const Vec3 s = (2.0 * over_squares) * (to_x + to_y + to_z);
  const Vec3 v = normal / volume;
  const Vec3 slope = 1.5 * s - v;
  sum.value += value;
  sum.gradient += value * slope;
  // Upper triangle of value (slope slope' - 1.5 s s' + v v' + 9 / squares).
  const Vec3 a = value * slope, b = (-1.5 * value) * s, c = value * v;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) sum.hessian(i, j) += a[i] * slope[j] + b[i] * s[j] + c[i] * v[j];
    sum.hessian(i, i) += 9.0 * over_squares * value;
  }
  return true;
}

}  // namespace octet
