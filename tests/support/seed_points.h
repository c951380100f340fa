// SPDX-License-Identifier: BSD-3-Clause
// Both steps of seeding, one after the other; and all that goes before them.
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

/// Of a tree made for that size.
inline Seeds seed_points(const Model& model, const Octree& tree, double size) {
  const OctreeVertices vertices = octree_vertices(tree);
  const OctantTypes types = octant_types(model, tree);
  const std::vector<OctantEdge> edges = boundary_octant_edges(tree, vertices, types);
  const std::vector<OctantEdgeCut> cuts = cut_octant_edges(model, tree, vertices, edges);
  return seed_points(model, tree, vertices, label_vertices(model, tree, vertices, types, edges, cuts), cuts,
                     {size});
}

}  // namespace octet::test
