// SPDX-License-Identifier: BSD-3-Clause
// What bounds two faces both: edges, and vertices with what lies about them.
#pragma once

#include <array>
#include <vector>

#include "geom/model.h"

namespace octet {

[[nodiscard]] bool have_common_edge(const ModelFace& a, const ModelFace& b);

struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

/// About the vertices that both faces have, by a thousandth of the model's diagonal and twice the vertex's
/// tolerance: where the faces come near within one, it is at that vertex.
[[nodiscard]] std::vector<Ball> about_common_vertices(const Model& model, const std::array<int, 2>& face);

/// Stretches of a segment, as shares of its length.
using Stretches = std::vector<std::array<double, 2>>;

/// What is left of a segment outside of the balls.
[[nodiscard]] Stretches outside_of(const std::vector<Ball>& balls, const Vec3& from, const Vec3& to);

}  // namespace octet
