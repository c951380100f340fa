// SPDX-License-Identifier: BSD-3-Clause
// How far an entity is from a place.
#pragma once

#include "geom/model.h"

namespace octet {

struct EntityFoot {
  Vec3 point = Vec3::Zero();  ///< of the entity, the nearest
  double distance = 0.0;
};

/// The nearest point of a vertex, an edge (ends included), a face (boundary included) or a region (the place
/// itself within it). Infinitely far from an edge without length.
[[nodiscard]] EntityFoot entity_foot(const Model& model, ModelRef entity, const Vec3& p);

}  // namespace octet
