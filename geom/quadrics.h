// SPDX-License-Identifier: BSD-3-Clause
// Plane, cylinder, cone and sphere in closed form.
#pragma once

#include <memory>

#include "geom/axes3.h"
#include "geom/surface.h"

namespace octet {

// Parametrisations (those of OpenCASCADE), c = cos u, s = sin u; u is reported in [u0, u0 + 2 pi):
//   plane     origin + u x + v y
//   cylinder  origin + radius (c x + s y) + v z
//   cone      origin + (radius + v sin a)(c x + s y) + v cos a z      a = semi_angle, of any sign
//   sphere    origin + radius cos v (c x + s y) + radius sin v z
// The (u,v) box is the whole surface, both nappes of a cone: a face's trim bounds it.
// A root is tangent when the line's distance from tangency is below rounding (about 1e-14 of the
// coordinates); a segment that lies in the surface gives two coincident roots, t = 0 and t = 1.

[[nodiscard]] std::shared_ptr<const Surface> make_plane(const Axes3& axes);
[[nodiscard]] std::shared_ptr<const Surface> make_cylinder(const Axes3& axes, double radius, double u0 = 0.0);
[[nodiscard]] std::shared_ptr<const Surface> make_cone(const Axes3& axes, double semi_angle, double radius,
                                                       double u0 = 0.0);
[[nodiscard]] std::shared_ptr<const Surface> make_sphere(const Axes3& axes, double radius, double u0 = 0.0);

}  // namespace octet
