// SPDX-License-Identifier: BSD-3-Clause
// Octants counted by where they lie.
#include "app/element_estimate.h"

#include <algorithm>

#include "app/element_limits.h"
#include "app/octant_sizes.h"
#include "octree/octant_types.h"

namespace octet {
double estimated_elements(const Model& model, const SizePlan& plan) {
  OctreeRequest request = octant_request(plan);
  request.max_within = std::max(request.max_within, most_octants_within(SizeControl().max_elements));
  return estimated_elements(model, build_octree(model, request, octant_samples(plan)));
}

double estimated_elements(const Model& model, const Octree& tree) {
  double elements = 0.0;
  for (const OctantType type : octant_types(model, tree).type) {
    if (type == OctantType::kIn) elements += kTetsPerOctant;
    if (type == OctantType::kBoundary) elements += kTetsPerBoundaryOctant;
  }
  return elements;
}

}  // namespace octet
