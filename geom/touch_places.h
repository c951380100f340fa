// SPDX-License-Identifier: BSD-3-Clause
// Where to look for faces that touch: by facets.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Where facets of two faces come near each other.
struct TouchPlace {
  double distance = 0.0;      ///< of the facets
  Vec3 at = Vec3::Zero();     ///< beside the first of the pair
  double reach = 0.0;         ///< how far about it the faces may be nearer still
  std::array<int, 2> face{};  ///< in the order to be tried
};

/// By pair, the lower tag first; the nearest few of each, the nearest first.
using TouchPlaces = std::map<std::array<int, 2>, std::vector<TouchPlace>>;

/// Of faces of one region without an edge in common, where their facets come as near as these deviate and
/// `near` allow, away from vertices of both.
[[nodiscard]] TouchPlaces touch_places(const Model& model, double near);

}  // namespace octet
