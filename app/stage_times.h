// SPDX-License-Identifier: BSD-3-Clause
// What a run took besides its stages.
#pragma once

#include <vector>

#include "app/mesh_part.h"

namespace octet {

/// What the making of a mesh took besides its own stages.
[[nodiscard]] StageTime beside_stages(StageTime whole, const std::vector<StageTime>& own);

/// What no stage has: where others were made before the mesh, their making; else looking for a size.
void add_rest(StageTime rest, int makings, std::vector<StageTime>& times);

}  // namespace octet
