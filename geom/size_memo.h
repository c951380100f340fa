// SPDX-License-Identifier: BSD-3-Clause
// What was found of one part while sizes for it are looked for.
#pragma once

#include "geom/sizing.h"
#include "geom/wall_sizing.h"

namespace octet {

struct SizeMemo {
  WallMemo walls;
  FeatureMemo features;
};

}  // namespace octet
