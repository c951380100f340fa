// SPDX-License-Identifier: BSD-3-Clause
// Pairs of faces that cross each other: a boundary that meets itself bounds nothing.
#pragma once

#include <array>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Two faces with a point in common that lies within both, where they meet at an angle.
struct FaceCrossing {
  std::array<int, 2> face{};  ///< ascending tags
  Vec3 place = Vec3::Zero();  ///< on both surfaces to rounding, where the crossing is deepest
  double depth = 0.0;         ///< how far either face goes beyond the other there, at least
};

/// All pairs of faces whose facets cross and whose surfaces then prove to: a point on both surfaces, inside
/// both loops, farther from the edges than these are off, the surfaces at an angle of 0.02 and more.
/// Crossings within the facets' deviation may be missed; none is told in error. Ascending by faces.
/// Looked for once; the model keeps them.
[[nodiscard]] const std::vector<FaceCrossing>& face_crossings(const Model& model);

}  // namespace octet
