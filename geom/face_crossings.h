// SPDX-License-Identifier: BSD-3-Clause
// Pairs of faces that cross each other: a boundary that meets itself bounds nothing.
#pragma once

#include <array>

#include "base/vec.h"

namespace octet {

/// Two faces with a point in common that lies within both, where they meet at an angle (Model::crossings()).
struct FaceCrossing {
  std::array<int, 2> face{};  ///< ascending tags
  Vec3 place = Vec3::Zero();  ///< on both surfaces to rounding, where the crossing is deepest
  double depth = 0.0;         ///< how far either face goes beyond the other there, at least
};

}  // namespace octet
