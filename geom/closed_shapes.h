// SPDX-License-Identifier: BSD-3-Clause
// Radius, axis and centre of surfaces and curves that have them.
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"
#include "geom/surface.h"

namespace octet {

/// A cylinder, cone, sphere or torus.
struct RoundShape {
  Vec3 origin = Vec3::Zero();  ///< of a cylinder some point of the axis, of a cone the apex, else the middle
  Vec3 axis = Vec3::Zero();    ///< unit, its largest component positive; zero for a sphere
  double radius = 0.0;         ///< of a torus from the axis to the middle of its tube; 0 for a cone
  double minor_radius = 0.0;   ///< of a torus' tube
  double half_angle = 0.0;     ///< of a cone, between axis and side, radians
};
/// Nothing for planes and free forms.
[[nodiscard]] std::optional<RoundShape> round_shape(const Surface& surface);

/// A circle, or an ellipse.
struct ConicShape {
  Vec3 centre = Vec3::Zero();
  Vec3 axis = Vec3::Zero();               ///< of its plane, unit, the largest component positive
  std::array<double, 2> radii{0.0, 0.0};  ///< the larger first
};
/// Nothing for lines and free forms.
[[nodiscard]] std::optional<ConicShape> conic_shape(const Curve& curve);

}  // namespace octet
