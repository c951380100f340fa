// SPDX-License-Identifier: BSD-3-Clause
// What the removal of an edge with few tetrahedra can win for the mean, told before it is planned.
#pragma once

#include "finalize/work_mesh.h"

namespace octet {

/// Rims of so many vertices and no more are looked at: there are two ways to fill one at most.
inline constexpr std::size_t kSmallRim = 4;

/// The most that the sum of merits (finalize/mean_shape.h) can rise by, to some 1e-12, when the ring's edge
/// is removed, also where the ring is open or has two triangles on a model face. The shapes of what would be
/// made, and what the model allows, are not looked at. Requires a rim of three or four vertices.
[[nodiscard]] double most_gain_of_removal(const WorkMesh& mesh, const EdgeRing& ring);

}  // namespace octet
