// SPDX-License-Identifier: BSD-3-Clause
// How many tetrahedra sizes will give, told from the octree alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "geom/size_plan.h"
#include "octree/octree.h"

namespace octet {

/// No mesh has more: numbers of nodes and elements have 4 bytes.
inline constexpr std::size_t kMostElements = std::numeric_limits<std::uint32_t>::max();

/// What else to do about a limit of elements that is too low: nothing where there can be no higher one.
[[nodiscard]] inline const char* or_raise(std::size_t max_elements) {
  return max_elements < kMostElements ? ", or raise --max-elements" : "";
}

/// Tetrahedra of a mesh with these sizes, to a tenth or two on most parts, at a small share of a mesh's cost:
/// octants inside and on the boundary are counted. Of planned_octree() for what is told.
[[nodiscard]] double estimated_elements(const Model& model, const Octree& tree);

/// The same for a search of sizes, which asks often: thin walls are not evened (octree/even_walls), which
/// costs half as much again and adds elements to few parts. Throws what build_octree() throws; of its octants
/// there may be as many as the default limit of elements allows, if the plan's own is less: a search goes
/// through finer sizes than those it ends with.
[[nodiscard]] double estimated_elements(const Model& model, const SizePlan& plan);

}  // namespace octet
