// SPDX-License-Identifier: BSD-3-Clause
// Slower growth of the octants than the one-level difference alone allows.
#pragma once

#include "octree/balance.h"

namespace octet {

/// The splits, and those needed so that around every octant of a level at least `layers` octants follow that
/// are at most twice as long, in every direction, before longer ones. One layer is what the one-level
/// difference gives (balanced() still has to be called): then the splits are returned as they are.
[[nodiscard]] SplitKeys graded(SplitKeys splits, int layers);

/// Layers for a largest ratio of neighbouring sizes: sizes double in `layers` steps, 2 = growth^layers.
[[nodiscard]] int layers_of_growth(double growth);

}  // namespace octet
