// SPDX-License-Identifier: BSD-3-Clause
// The foot of a point on one of OCCT's surfaces, from parameters nearby.
#pragma once

#include <Geom_Surface.hxx>
#include <array>

#include "base/vec.h"

namespace octet {

/// The ranges that surface parameters stay within; of a periodic one there is none.
struct SurfaceBounds {
  std::array<double, 2> low{}, high{};
};

[[nodiscard]] SurfaceBounds bounds_of(const Geom_Surface& surface);

/// Newton's method for the foot of a point on a surface, from `uv`. At a pole the parameter that moves
/// nothing stays.
[[nodiscard]] Vec2 foot_from(const Geom_Surface& surface, const SurfaceBounds& bounds, const Vec3& point,
                             Vec2 uv);

}  // namespace octet
