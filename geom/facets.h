// SPDX-License-Identifier: BSD-3-Clause
// A welded, watertight triangulation of the model's boundary: an accelerator, never the truth.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// Nodes are welded by topology: one node per model vertex, one list per model edge used by all its faces.
///
/// Invariants: triangles of face f are oriented as the face (normal by the right-hand rule = face normal);
/// on the boundary of a closed region every facet edge is used once in each direction (`open_facet_edges`).
struct Facets {
  std::vector<Vec3> nodes;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> face;       ///< per triangle: model face tag
  std::vector<std::array<Vec2, 3>> uv;  ///< per triangle and corner, continuous within a triangle
  std::vector<double>
      deviation;  ///< per face tag (index 0 unused): measured distance surface to facets, inflated
  std::vector<double>
      edge_deviation;  ///< per edge tag (index 0 unused): measured distance curve to its polyline, inflated
};

/// The corners of a facet of the model.
[[nodiscard]] inline std::array<Vec3, 3> facet_corners(const Facets& facets, std::size_t triangle) {
  const auto& t = facets.triangles[triangle];
  return {facets.nodes[t[0]], facets.nodes[t[1]], facets.nodes[t[2]]};
}

}  // namespace octet
