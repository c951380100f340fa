// SPDX-License-Identifier: BSD-3-Clause
// Where the size asked for could not be met.
#pragma once

#include <functional>
#include <vector>

#include "base/model_ref.h"
#include "mesh/mesh.h"

namespace octet {

/// The edge of the mesh on one model edge or face that is the shortest for the size asked for at its middle.
struct ShortEdge {
  ModelRef entity;
  Vec3 place = Vec3::Zero();
  double length = 0.0, asked = 0.0;  ///< model units
};

struct SizeShortfall {
  std::size_t edges = 0;            ///< of the boundary, shorter than kFarTooShort of the size asked for
  std::vector<ShortEdge> shortest;  ///< one an entity, the worst first; no more than kShortEdgesTold

  /// Keeps the worst of both.
  void add(const SizeShortfall& other);
};

inline constexpr double kFarTooShort = 0.25;
inline constexpr std::size_t kShortEdgesTold = 10;

/// `size_at`: the size asked for at a place. O(n log n) in the boundary.
[[nodiscard]] SizeShortfall size_shortfall(const Mesh& mesh,
                                           const std::function<double(const Vec3&)>& size_at);

}  // namespace octet
