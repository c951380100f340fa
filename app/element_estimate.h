// SPDX-License-Identifier: BSD-3-Clause
// How many tetrahedra sizes will give, told from the octree alone.
#pragma once

#include "geom/size_plan.h"

namespace octet {

/// Tetrahedra of a mesh with these sizes, to a tenth or two on most parts, at a small share of a mesh's cost:
/// octants inside and on the boundary are counted. Throws what build_octree() throws.
[[nodiscard]] double estimated_elements(const Model& model, const SizePlan& plan);

}  // namespace octet
