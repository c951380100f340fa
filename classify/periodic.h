// SPDX-License-Identifier: BSD-3-Clause
// Whether the meshes of entities that are each other's images are so, too.
#pragma once

#include <vector>

#include "classify/acceptance.h"
#include "geom/periodicity.h"
#include "mesh/periodic_link.h"

namespace octet {

inline constexpr const char* kPeriodicClaim = "periodic";

struct PeriodicMatch {
  Claim claim;
  /// Of all entities but the first of each orbit, with that one as their source; vertices, edges that are one
  /// piece, faces. Only of those whose nodes all have their images.
  std::vector<PeriodicLink> links;
};

/// `periodicity` is the model's. Requires that the claim `numbers` holds for the mesh.
[[nodiscard]] PeriodicMatch match_periodic(const Mesh& mesh, const Model& model,
                                           const Periodicity& periodicity);

}  // namespace octet
