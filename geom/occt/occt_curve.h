// SPDX-License-Identifier: BSD-3-Clause
// A curve without closed form: B-spline, Bezier, hyperbola, parabola, offset.
#pragma once

#include <memory>

#include "geom/occt/curve_jets.h"
#include "geom/surface.h"

namespace octet {

/// The curve over [t0, t1].
[[nodiscard]] std::shared_ptr<const Curve> make_free_curve(CurveJets jets, double t0, double t1);

}  // namespace octet
