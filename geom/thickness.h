// SPDX-License-Identifier: BSD-3-Clause
// The thinnest wall of a part.
#pragma once

#include <optional>

#include "geom/model.h"

namespace octet {

/// Two places of the boundary that face each other across a region.
struct Wall {
  double thickness = 0.0;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  int face = 0, opposite = 0;  ///< tags, possibly the same (a rod)
  int region = 0;
};

/// The least distance straight through a region from the middle of a facet to a face that looks the other way
/// within 30 degrees. Where two faces meet in an edge the wall runs out to nothing: places nearer to that
/// edge than three thicknesses do not count. A sample, one per facet but at most 10 000 on a face, none on
/// slivers (geom/tiny_features): between samples a wall may be thinner.
/// None where no two faces face each other. Cost: one segment per facet and side.
[[nodiscard]] std::optional<Wall> thinnest_wall(const Model& model);

}  // namespace octet
