// SPDX-License-Identifier: BSD-3-Clause
// Boxes about edges, faces and regions.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// Per tag, [0] unused; empty for an edge without length.
struct EntityBoxes {
  std::vector<Box3> edge, face, region;
};

/// Of edges to rounding, and so of planes, cylinders, cones, spheres and tori (their edges and the places
/// where they turn back); of free forms the box of the facets, grown by their deviation. Of a region the box
/// of its faces. Cost: some hundred curve points for each piece of a bent edge.
[[nodiscard]] EntityBoxes entity_boxes(const Model& model);

}  // namespace octet
