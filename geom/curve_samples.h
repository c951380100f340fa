// SPDX-License-Identifier: BSD-3-Clause
// Points along a curve from which a search for the nearest point starts.
#pragma once

#include <vector>

#include "geom/surface.h"

namespace octet {

/// Nearest point of a curve, over its whole range.
struct CurveFoot {
  double t = 0.0;
  Vec3 point = Vec3::Zero();
  double distance = 0.0;
};

/// Curves whose projection is global by itself (lines, circles, ellipses) keep one sample, others 65.
class CurveSamples {
 public:
  CurveSamples() = default;
  CurveSamples(const Curve& curve, double t0, double t1);

  /// Projection started at the three best local minima of the sampled distance; ends included.
  [[nodiscard]] CurveFoot nearest(const Curve& curve, const Vec3& p) const;

 private:
  std::vector<double> t_;
  std::vector<Vec3> point_;
};

}  // namespace octet
