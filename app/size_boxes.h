// SPDX-License-Identifier: BSD-3-Clause
// The sizes of a plan over space, as the octree has them.
#pragma once

#include "geom/size_plan.h"
#include "io/size_field_write.h"

namespace octet {

/// The octants inside the part and on its boundary, each with the edge length that its elements will have.
/// Throws what build_octree() throws.
[[nodiscard]] SizeBoxes size_boxes(const Model& model, const SizePlan& plan);

}  // namespace octet
