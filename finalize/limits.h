// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Whether the worst angle of t comes from the part: from a model edge that closes at less than twice the
/// target angle, from two model edges that meet at less than that, or from a wall around t that is thinner
/// than half of the local size.
[[nodiscard]] bool limited_by_geometry(Workshop& shop, TetId t);

}  // namespace octet
