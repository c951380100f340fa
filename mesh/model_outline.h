// SPDX-License-Identifier: BSD-3-Clause
// What a writer needs to know of the part: numbers, names, boxes and bounding relations. No geometry.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mesh/periodic_link.h"

namespace octet {

struct OutlineEntity {
  int tag = 0;
  std::string name;                     ///< empty when the CAD gives none; so are the next three
  std::string colour, layer, material;  ///< colour "#rrggbb"; several layers separated by ", "
  Box3 box;
  /// Tags one dimension below; negative when the orientation is opposite: an edge lists (start, -end), a
  /// face its edges by sense, a region its faces. Entities of dimension 0 list none.
  std::vector<int> bounded_by;
};

/// Entities of one dimension that the user names together.
struct OutlineGroup {
  std::string name;
  int dim = 0;
  std::vector<int> tags;  ///< ascending
};

/// Entities per dimension 0..3, ascending by tag.
struct ModelOutline {
  std::array<std::vector<OutlineEntity>, 4> entities;
  std::vector<OutlineGroup> groups;
  std::vector<PeriodicLink> links;  ///< of the mesh that is written
};

}  // namespace octet
