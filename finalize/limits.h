// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Whether the worst angle of t comes from the part: from a model edge that closes at less than twice the
/// target angle, or from a wall, all four corners on the boundary but not on one face, that is thinner than
/// half of the local size.
[[nodiscard]] bool limited_by_geometry(Workshop& shop, TetId t);

}  // namespace octet
