// SPDX-License-Identifier: BSD-3-Clause
// The torus in closed form.
#pragma once

#include <memory>

#include "geom/axes3.h"
#include "geom/surface.h"

namespace octet {

/// origin + (major + minor cos v)(cos u x + sin u y) + minor sin v z, (u,v) in [u0, u0 + 2 pi) x [v0, v0 + 2
/// pi). Ring, horn (minor = major) and spindle (minor > major) tori.
[[nodiscard]] std::shared_ptr<const Surface> make_torus(const Axes3& axes, double major, double minor,
                                                        double u0 = 0.0, double v0 = 0.0);

}  // namespace octet
