// SPDX-License-Identifier: BSD-3-Clause
// A wish for a mesh size at a place.
#pragma once

#include "base/vec.h"

namespace octet {

/// Elements around `place` should have edges no longer than `size` (model units).
struct SizeSample {
  Vec3 place = Vec3::Zero();
  double size = 0.0;
};

}  // namespace octet
