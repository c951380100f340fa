// SPDX-License-Identifier: BSD-3-Clause
// Lines, circles and ellipses in closed form.
#pragma once

#include <memory>

#include "geom/axes3.h"
#include "geom/surface.h"

namespace octet {

/// origin + t direction, t in [t0, t1]; `direction` need not be a unit vector.
[[nodiscard]] std::shared_ptr<const Curve> make_line(const Vec3& origin, const Vec3& direction, double t0,
                                                     double t1);
/// origin + radius (cos t x + sin t y), t in [t0, t1], at most one turn.
[[nodiscard]] std::shared_ptr<const Curve> make_circle(const Axes3& axes, double radius, double t0,
                                                       double t1);
/// origin + major cos t x + minor sin t y, t in [t0, t1], at most one turn.
[[nodiscard]] std::shared_ptr<const Curve> make_ellipse(const Axes3& axes, double major, double minor,
                                                        double t0, double t1);

}  // namespace octet
