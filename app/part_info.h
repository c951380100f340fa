// SPDX-License-Identifier: BSD-3-Clause
// What `octet info` tells of a part.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/changed_numbers.h"
#include "app/self_contact.h"
#include "geom/face_contacts.h"
#include "geom/face_crossings.h"
#include "geom/model.h"
#include "geom/thickness.h"
#include "geom/tiny_features.h"

namespace octet {

/// The faces that two regions share.
struct Interface {
  std::array<int, 2> regions{0, 0};  ///< ascending
  std::vector<int> faces;            ///< ascending
  double area = 0.0;                 ///< mm^2
};

struct PartInfo {
  /// Of the facets' nodes, which lie on the part: short of the exact box by no more than the facets deviate
  /// (nothing on planar parts). Model::box() is the safe one.
  Box3 box;
  int smallest_edge = 0;  ///< tag of the shortest real edge, 0: none
  int smallest_face = 0;  ///< tag of the face of least area, 0: none
  double volume = 0.0;    ///< of all regions, mm^3
  double area = 0.0;      ///< of all faces between two regions or a region and the outside, mm^2
  int seams = 0, degenerate = 0;
  std::vector<int> free_edges;  ///< real edges with one face on one side only
  std::vector<TinyFeature> tiny;
  ModelRef widest_gap;  ///< the edge or vertex of the largest measured tolerance; tag 0: none
  SelfContact contact;
  std::vector<int> embedded_faces;      ///< faces with the same region on both sides
  std::vector<int> dangling_faces;      ///< faces with none on either
  std::vector<FaceCrossing> crossings;  ///< of all pairs of faces, and of faces with themselves
  std::vector<Interface> interfaces;    ///< ascending by regions
  std::vector<FaceContact> touching;    ///< faces of solids that are kept apart
  std::vector<Overlap> overlaps;
  std::vector<NumberChange> changes;  ///< but for what is not in the model (that is LeftOut)
  std::optional<Wall> thinnest;
  double default_size = 0.0;  ///< what `octet mesh` takes without --size, mm
};

[[nodiscard]] PartInfo part_info(const Model& model);

}  // namespace octet
