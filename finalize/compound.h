// SPDX-License-Identifier: BSD-3-Clause
// Compound moves: an operation that makes things worse at first, and what mends them.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Tries operations at t that leave something worse than t (a removal, a collapse, a split), each followed by
/// swaps and smoothing of what they made, and keeps the first after which all that was touched is better than
/// t was; all others are taken back. Changes nothing when it returns false. [Klingner & Shewchuk 2007]
bool improve_by_compound(Workshop& shop, TetId t, double goal);

}  // namespace octet
