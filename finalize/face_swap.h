// SPDX-License-Identifier: BSD-3-Clause
// Face swap: two tetrahedra that share a face become three around the edge between their far vertices.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Swaps face `face` of t if the worst shape gets better than `floor`. Faces on model faces stay.
bool swap_face(Workshop& shop, TetId t, int face, double floor);

/// Swaps if that raises the sum of merits (finalize/mean_shape.h) and no new tetrahedron is as bad as
/// `floor`.
bool swap_face_for_mean(Workshop& shop, TetId t, int face, double floor);
/// Whether it would. Changes nothing; many threads may ask at once.
[[nodiscard]] bool face_swap_raises_mean(const Workshop& shop, TetId t, int face, double floor);

}  // namespace octet
