// SPDX-License-Identifier: BSD-3-Clause
// Face swap: two tetrahedra that share a face become three around the edge between their far vertices.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Swaps face `face` of t if the worst shape gets better than `floor`. Faces on model faces stay.
bool swap_face(Workshop& shop, TetId t, int face, double floor);

}  // namespace octet
