// SPDX-License-Identifier: BSD-3-Clause
// Octants outside are left out, and so are the points that they alone have.
#include "app/size_boxes.h"

#include "app/octant_sizes.h"
#include "octree/octant_types.h"
#include "octree/vertices.h"

namespace octet {

SizeBoxes size_boxes(const Model& model, const SizePlan& plan) {
  const Octree tree = planned_octree(model, plan);
  const OctreeVertices vertices = octree_vertices(tree);
  const OctantTypes types = octant_types(model, tree);
  std::vector<std::uint32_t> number(vertices.size(), kNoVertex);
  SizeBoxes field;
  for (std::size_t o = 0; o < tree.size(); ++o) {
    if (types.type[o] == OctantType::kOut) continue;
    auto& box = field.boxes.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) {
      const std::uint32_t v = vertices.corners[o][c];
      if (number[v] == kNoVertex) {
        number[v] = static_cast<std::uint32_t>(field.points.size());
        field.points.push_back(tree.position(vertices.at[v]));
      }
      box[c] = number[v];
    }
    field.size.push_back(kEdgePerOctant * tree.length(tree.octants()[o].level));
  }
  return field;
}

}  // namespace octet
