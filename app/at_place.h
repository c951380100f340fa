// SPDX-License-Identifier: BSD-3-Clause
// What of a part is at a place, for `octet info --at`.
#pragma once

#include <string>
#include <vector>

#include "geom/model.h"

namespace octet {

struct NearEntity {
  ModelRef entity;
  double distance = 0.0;
  Vec3 point = Vec3::Zero();  ///< of it, the nearest
};

struct AtPlace {
  Vec3 place = Vec3::Zero();
  /// The vertex, the edge and the face on which it lies, and those as near as the nearest: by dimension from
  /// the faces down, then by tag. Places are one within the entity's tolerance and 1e-6 of the diagonal.
  std::vector<NearEntity> nearest;
  ModelRef on;               ///< the entity of least dimension that holds it (no seam); tag 0: none
  std::vector<int> regions;  ///< within which, or on whose boundary, it lies; ascending
};

/// "x,y,z" in a unit that is so long. InputError.
[[nodiscard]] Vec3 parse_place(const std::string& text, double unit);
/// Cost: exact queries of all entities.
[[nodiscard]] AtPlace at_place(const Model& model, const Vec3& place);

}  // namespace octet
