// SPDX-License-Identifier: BSD-3-Clause
// Faces that cross each other, or themselves: a boundary that meets itself bounds nothing.
#pragma once

#include <array>

#include "base/vec.h"

namespace octet {

/// Two faces with a point in common that lies within both, where they meet at an angle, or one that passes a
/// point twice so, as a pipe does that is bent tighter than it is thick (Model::crossings()).
struct FaceCrossing {
  std::array<int, 2> face{};  ///< ascending tags; twice the same: it crosses itself
  Vec3 place = Vec3::Zero();  ///< on both surfaces to rounding, where the crossing is deepest
  double depth = 0.0;         ///< how far either face goes beyond the other there, at least

  [[nodiscard]] bool is_of_itself() const { return face[0] == face[1]; }
};

}  // namespace octet
