// SPDX-License-Identifier: BSD-3-Clause
// Arc length along a curve, both ways.
#pragma once

#include <vector>

#include "geom/surface.h"

namespace octet {

/// A table of the curve's length over [t0, t1], by Gauss-Legendre on spans halved until they agree.
///
/// Relative error about 1e-11 on smooth curves. Keeps no reference to the curve: pass the same one each time.
class ArcLength {
 public:
  ArcLength() = default;
  ArcLength(const Curve& curve, double t0, double t1);

  [[nodiscard]] double total() const { return length_.empty() ? 0.0 : length_.back(); }
  [[nodiscard]] double length(const Curve& curve, double t_from, double t_to) const;
  /// Parameter at signed length s from `t_from`, clamped to [t0, t1].
  [[nodiscard]] double parameter(const Curve& curve, double t_from, double s) const;
  /// The ends of the spans, ascending: dense where the speed varies.
  [[nodiscard]] const std::vector<double>& knots() const { return knot_; }

 private:
  void add_span(const Curve& curve, double a, double b, double whole, int depth);
  [[nodiscard]] double from_start(const Curve& curve, double t) const;

  std::vector<double> knot_;
  std::vector<double> length_;  ///< from the first knot to each
};

}  // namespace octet
