// SPDX-License-Identifier: BSD-3-Clause
// Lengths, areas, volumes and tolerances of the entities, as they are and not as the file states them.
#pragma once

#include "geom/model.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Fills length, area, volume and tolerance; after tessellate(). Notes edges whose gap is larger than the
/// file's tolerance. ModelError: a solid of negative volume (its faces are turned inside out).
void measure(const Numbering& numbering, ModelParts& parts);

}  // namespace octet
