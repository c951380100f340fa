// SPDX-License-Identifier: BSD-3-Clause
// Edges that turn back within a piece.
#pragma once

#include <algorithm>

#include "geom/model.h"

namespace octet {

/// Whether the edge turns back between two of its points, as at the end of a narrow groove, so that a piece
/// from one to the other leaves out what is beyond: by more than 60 degrees, and its length is more than 1.3
/// times the distance of the points, all that the claim about lengths takes for a chord's error. `ta`, `tb`:
/// their parameters, in either order.
[[nodiscard]] inline bool turns_back(const Model& model, int edge, double ta, const Vec3& a, double tb,
                                     const Vec3& b) {
  constexpr double kTurned = 0.5;  // cosine between the directions at the ends
  constexpr double kLonger = 1.3;
  const Vec3 from = model.edge_derivative(edge, ta), to = model.edge_derivative(edge, tb);
  return from.dot(to) <= kTurned * from.norm() * to.norm() &&
         model.edge_length(edge, std::min(ta, tb), std::max(ta, tb)) > kLonger * (b - a).norm();
}

}  // namespace octet
