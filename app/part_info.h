// SPDX-License-Identifier: BSD-3-Clause
// What `octet info` tells of a part.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

struct PartInfo {
  /// Of the facets' nodes, which lie on the part: short of the exact box by no more than the facets deviate
  /// (nothing on planar parts). Model::box() is the safe one.
  Box3 box;
  int smallest_edge = 0;  ///< tag of the shortest real edge, 0: none
  int smallest_face = 0;  ///< tag of the face of least area, 0: none
  double volume = 0.0;    ///< of all regions, mm^3
  double area = 0.0;      ///< of all faces between two regions or a region and the outside, mm^2
  int seams = 0, degenerate = 0;
  std::vector<int> free_edges;      ///< real edges with one face on one side only
  std::vector<int> nonmanifold;     ///< real edges with more than two faces
  std::vector<int> dangling_faces;  ///< faces with the same region, or none, on both sides
  double default_size = 0.0;        ///< what `octet mesh` takes without --size, mm
};

[[nodiscard]] PartInfo part_info(const Model& model);

}  // namespace octet
