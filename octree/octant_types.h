// SPDX-License-Identifier: BSD-3-Clause
// What each octant is: in a region, outside, or on the boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "octree/octree.h"

namespace octet {

enum class OctantType : std::int8_t { kOut, kIn, kBoundary };

struct OctantTypes {
  std::vector<OctantType> type;      ///< per octant
  std::vector<std::int32_t> region;  ///< per octant: region tag when kIn, else 0
};

/// Boundary octants by the model's facets, which may say yes in vain; regions of the others by flood fill
/// through faces, one exact query a connected component [Handbook 15.4.3]. Whole subtrees that the boundary
/// does not meet are one unit, so the cost goes with the boundary and not with the volume.
[[nodiscard]] OctantTypes octant_types(const Model& model, const Octree& tree);

}  // namespace octet
