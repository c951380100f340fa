// SPDX-License-Identifier: BSD-3-Clause
// The measure that finalization raises: the square of the smallest sine of a tetrahedron's dihedral angles.
#pragma once

#include <array>

#include "base/vec.h"

namespace octet {

/// Square of the smallest of the six sines, in [0, 8/9]; it falls for angles near 0 and near pi alike. Zero
/// or negative when the volume (in doubles) is not positive. Smooth where one angle alone is the worst; no
/// square root, no trigonometry: it is evaluated a hundred times for each tetrahedron made.
[[nodiscard]] double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The six squares, each with the sign of the volume, in the order of kTetEdge (mesh/tet_mesh.h).
[[nodiscard]] std::array<double, 6> squared_sines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The measure of a tetrahedron whose worst dihedral angle is `radians`.
[[nodiscard]] double shape_of_angle(double radians);

}  // namespace octet
