// SPDX-License-Identifier: BSD-3-Clause
// What each octree vertex is: in which region, or outside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/fault.h"
#include "octree/octant_edges.h"
#include "octree/octant_types.h"
#include "octree/vertices.h"

namespace octet {

struct OctantEdgeCut;

/// Invariant: where an octant edge has no cut, its two ends have the same region, but for `conflicts`.
struct OctreeLabels : OctantTypes {
  std::vector<std::int32_t> vertex_region;  ///< per octree vertex: region tag, 0 outside
  std::vector<Fault>
      conflicts;  ///< parity conflicts: places where cuts and labels disagree (a defect to be found)
};

/// Vertices of octants off the boundary take their octants' regions; from there regions spread along the
/// edges of boundary octants, changed by each cut as the cut face's regions say [Schroeder & Shephard 1990,
/// "Tree building"]. Tangent, coincident and end-point events and events on model edges and vertices say
/// nothing about parity: no path leads along such an edge. Vertices that no path reaches are asked for
/// exactly. Where an edge's cuts disagree with the regions of its ends, a Fault is told and both ends are
/// asked for exactly. `edges` are those of boundary_octant_edges(), `cuts` theirs of cut_octant_edges().
[[nodiscard]] OctreeLabels label_vertices(const Model& model, const Octree& tree,
                                          const OctreeVertices& vertices, const OctantTypes& types,
                                          std::span<const OctantEdge> edges,
                                          const std::vector<OctantEdgeCut>& cuts);

}  // namespace octet
