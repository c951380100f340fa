// SPDX-License-Identifier: BSD-3-Clause
// A curve without closed form: B-spline, Bezier, hyperbola, parabola, offset.
#pragma once

#include <Geom_Curve.hxx>
#include <memory>

#include "geom/surface.h"

namespace octet {

/// The curve over [t0, t1], evaluated on the Geom handle, which OCCT lets threads share.
[[nodiscard]] std::shared_ptr<const Curve> make_free_curve(const Handle(Geom_Curve) & curve, double t0,
                                                           double t1);

}  // namespace octet
