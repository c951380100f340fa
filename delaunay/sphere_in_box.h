// SPDX-License-Identifier: BSD-3-Clause
// Whether a circumsphere stays within a box, without trust in its computed centre.
#pragma once

#include "base/vec.h"

namespace octet {

/// Whether the sphere through the corners of the tetrahedron lies in the closed box; exact for all finite
/// doubles, noise-flat tetrahedra included. Requires orient3d(a,b,c,d) = +1.
[[nodiscard]] bool sphere_in_box(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Box3& box);

}  // namespace octet
