// SPDX-License-Identifier: BSD-3-Clause
// How many tetrahedra sizes will give, told from the octree alone.
#pragma once

#include "geom/size_plan.h"
#include "octree/octree.h"

namespace octet {

/// Of a boundary octant about half lies inside, in more and flatter tetrahedra: the median over 80 parts.
inline constexpr double kTetsPerBoundaryOctant = 7.0;

/// Tetrahedra of a mesh with these sizes, to a tenth or two on most parts, at a small share of a mesh's cost:
/// octants inside and on the boundary are counted. Of planned_octree() for what is told.
[[nodiscard]] double estimated_elements(const Model& model, const Octree& tree);

/// The same for a search of sizes, which asks often: thin walls are not evened (octree/even_walls), which
/// costs half as much again and adds elements to few parts. Throws what build_octree() throws; of its octants
/// there may be as many as the default limit of elements allows, if the plan's own is less: a search goes
/// through finer sizes than those it ends with.
[[nodiscard]] double estimated_elements(const Model& model, const SizePlan& plan);

}  // namespace octet
