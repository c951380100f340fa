// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a curve: splines as one polynomial per knot span.
#pragma once

#include <Geom_Curve.hxx>
#include <vector>

#include "base/vec.h"

namespace octet {

struct CurveJet {
  Vec3 p = Vec3::Zero(), d1 = Vec3::Zero(), d2 = Vec3::Zero(), d3 = Vec3::Zero();
};

/// B-spline and Bezier curves in the power basis about the middle of each span, some ten times faster than
/// OCCT's own and to rounding of it; other curves through their Geom handle, which OCCT lets threads share.
/// Immutable, thread-safe. Memory: 32 bytes a coefficient.
class CurveJets {
 public:
  explicit CurveJets(Handle(Geom_Curve) curve);

  /// `derivatives` is 0 to 3; what is above it is left zero.
  [[nodiscard]] CurveJet evaluate(double t, int derivatives) const;
  /// Parameters at which the curvature may jump, over one period; none for curves that are smooth.
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  [[nodiscard]] double period() const { return period_; }  ///< 0: not periodic

 private:
  Handle(Geom_Curve) curve_;
  std::vector<double> knots_;
  double period_ = 0.0;
  int degree_ = -1;  ///< -1: no spline
  bool rational_ = false;
  std::vector<Vec3> centres_;                  ///< by span: coordinates are relative to it
  std::vector<Eigen::Vector4d> coefficients_;  ///< by span, then power; homogeneous
};

}  // namespace octet
