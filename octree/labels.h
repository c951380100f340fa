// SPDX-License-Identifier: BSD-3-Clause
// What each octant and each octree vertex is: in a region, outside, or on the boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "base/fault.h"
#include "octree/vertices.h"

namespace octet {

enum class OctantType : std::int8_t { kOut, kIn, kBoundary };

/// Invariant: where an octant edge has no cut, its two ends have the same region.
struct OctreeLabels {
  std::vector<OctantType> type;             ///< per octant
  std::vector<std::int32_t> region;         ///< per octant: region tag when kIn, else 0
  std::vector<std::int32_t> vertex_region;  ///< per octree vertex: region tag, 0 outside
  std::vector<Fault>
      conflicts;  ///< parity conflicts: places where cuts and labels disagree (a defect to be found)
};

/// Types by the model's facets, regions by flood fill over octants that the boundary does not meet, one exact
/// query a connected component; labels of the vertices of boundary octants by parity along octant edges from
/// labelled ones, exact query where no path leads [Schroeder & Shephard 1990, "Tree building"].
[[nodiscard]] OctreeLabels label_octree(const Model& model, const Octree& tree,
                                        const OctreeVertices& vertices);

}  // namespace octet
