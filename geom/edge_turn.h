// SPDX-License-Identifier: BSD-3-Clause
// How much longer than a straight piece an edge is, and where it turns back within one.
#pragma once

#include <algorithm>

#include "geom/model.h"

namespace octet {

/// So many times its chord a piece of an edge may be long: of a longer one the claim about lengths takes no
/// more than this for a chord's error.
inline constexpr double kMostOverChord = 1.3;

/// A place on a model edge.
struct OnEdge {
  Vec3 point;
  double t = 0.0;
};

/// Length of the edge between two of its points, in either order, over their distance.
[[nodiscard]] inline double arc_over_chord(const Model& model, int edge, const OnEdge& a, const OnEdge& b) {
  return model.edge_length(edge, std::min(a.t, b.t), std::max(a.t, b.t)) / (b.point - a.point).norm();
}

/// Whether the edge turns back between the two, by more than 60 degrees and so that a piece from one to the
/// other leaves out what is beyond, as at the end of a narrow groove.
[[nodiscard]] inline bool turns_back(const Model& model, int edge, const OnEdge& a, const OnEdge& b) {
  constexpr double kTurned = 0.5;  // cosine between the directions at the ends
  const Vec3 from = model.edge_derivative(edge, a.t), to = model.edge_derivative(edge, b.t);
  return from.dot(to) <= kTurned * from.norm() * to.norm() &&
         arc_over_chord(model, edge, a, b) > kMostOverChord;
}

}  // namespace octet
