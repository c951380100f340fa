// SPDX-License-Identifier: BSD-3-Clause
// B-spline and Bezier surfaces as one polynomial patch per knot span.
#pragma once

#include <Geom_Surface.hxx>
#include <memory>
#include <vector>

#include "geom/surface.h"

namespace octet {

/// Third derivatives at (u, v).
struct SurfaceThirds {
  Vec3 uuu = Vec3::Zero(), uuv = Vec3::Zero(), uvv = Vec3::Zero(), vvv = Vec3::Zero();
};

/// Evaluates about ten times faster than Geom_BSplineSurface, to rounding of it: homogeneous coefficients in
/// the power basis about the middle of each span. Memory: 32 bytes a coefficient. Immutable, thread-safe.
class SplineSpans {
 public:
  /// Null where the surface is no spline, or the power basis does not keep its digits.
  [[nodiscard]] static std::unique_ptr<const SplineSpans> make(const Handle(Geom_Surface) & surface);

  /// `derivatives` is 0, 1 or 2, or 3 with a place for the third ones.
  [[nodiscard]] SurfaceJet evaluate(const Vec2& uv, int derivatives, SurfaceThirds* thirds = nullptr) const;

 private:
  struct Axis {
    std::vector<double> knots;
    double period = 0.0;  ///< 0: not periodic
    int degree = 0;
    /// Index of the span and the place in it, -1/2..1/2; beyond the ends the last span goes on.
    [[nodiscard]] std::size_t locate(double t, double& local, double& width) const;
  };

  Axis u_, v_;
  bool rational_ = false;
  std::vector<Vec3> centres_;                  ///< by u span, v span: coordinates are relative to it
  std::vector<Eigen::Vector4d> coefficients_;  ///< by u span, v span, power of u, power of v
};

}  // namespace octet
