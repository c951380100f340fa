// SPDX-License-Identifier: BSD-3-Clause
// Centres of gravity of edges, faces and regions.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// Per tag, [0] unused; zero where the entity has no extent.
struct Centroids {
  std::vector<Vec3> face, region;
};

/// Of planes along their exact edges; of other faces on the exact surface, up to the facets' borders in
/// (u,v): edges that are bent there leave an error of the order of the facets' deviation. Cost: a hundred
/// curve points for each piece of a plane's edge, twelve surface points for each facet.
[[nodiscard]] Centroids centroids(const Model& model);

}  // namespace octet
