// SPDX-License-Identifier: BSD-3-Clause
// From the part to what a mesh writer needs to know of it.
#pragma once

#include "geom/model.h"
#include "mesh/model_outline.h"

namespace octet {

/// Tags, names, boxes and bounding relations of every entity. Seams are left out of the faces' boundaries
/// (both sides would cancel), degenerate edges keep their place so that tags stay those of the CAD.
[[nodiscard]] ModelOutline outline_of(const Model& model);

}  // namespace octet
