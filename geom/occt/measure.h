// SPDX-License-Identifier: BSD-3-Clause
// Lengths, areas, volumes and tolerances of the entities, as they are and not as the file states them.
#pragma once

#include <cstddef>
#include <vector>

#include "geom/model.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Fills lengths and tolerances; after fill_topology(). Notes edges whose gap is larger than the file's
/// tolerance. ModelError: an edge off its faces, or with an end off its vertex, by more than half its length
/// and a twentieth of the part's.
void measure_gaps(const Numbering& numbering, ModelParts& parts);

/// Points inside the edge, evenly by its parameter; none where it has no curve.
[[nodiscard]] std::vector<Vec3> edge_samples(const ModelParts& parts, std::size_t edge);

/// Fills areas and volumes; after tessellate(). ModelError: a solid of negative volume (its faces are turned
/// inside out).
void measure_volumes(const Numbering& numbering, ModelParts& parts);

}  // namespace octet
