// SPDX-License-Identifier: BSD-3-Clause
// Axes that turn with the part.
#pragma once

#include "geom/model.h"

namespace octet {

/// The rows are orthonormal and right-handed: the part's own axes, the same whichever way it lies. Where a
/// part has planes, the first axis is the normal of the most area of them, the second that of the most area
/// at right angles to it; what planes leave open is taken from the second moments of the surface, and where
/// these are equal from the vertex farthest away. Of equal ones the first in the order of entities counts.
/// Axes along the coordinate axes are exactly along them; the identity for parts like a ball.
[[nodiscard]] Eigen::Matrix3d own_axes(const Model& model);

}  // namespace octet
