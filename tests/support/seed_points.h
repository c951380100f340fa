// SPDX-License-Identifier: BSD-3-Clause
// Both steps of seeding, one after the other.
#pragma once

#include "octree/seeds.h"

namespace octet::test {

inline Seeds seed_points(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                         const OctreeLabels& labels, const std::vector<OctantEdgeCut>& cuts,
                         const SeedOptions& options) {
  Seeder seeder(model, tree, options);
  seeder.seed_boundary(cuts);
  return seeder.seed_octree(vertices, labels);
}

}  // namespace octet::test
