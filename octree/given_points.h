// SPDX-License-Identifier: BSD-3-Clause
// Edges and faces whose points do not come from the octree.
#pragma once

#include <optional>
#include <vector>

#include "geom/periodicity.h"

namespace octet {

/// Points of edges and faces, which get these and no others before attribute points.
struct GivenPoints {
  /// Per edge tag ([0] unused): parameters, ascending; none where the octree tells.
  std::vector<std::optional<std::vector<double>>> on_edge;
  std::vector<std::optional<std::vector<Vec3>>> on_face;  ///< likewise

  [[nodiscard]] bool has_edge(int tag) const {
    return static_cast<std::size_t>(tag) < on_edge.size() && on_edge[static_cast<std::size_t>(tag)];
  }
  [[nodiscard]] bool has_face(int tag) const {
    return static_cast<std::size_t>(tag) < on_face.size() && on_face[static_cast<std::size_t>(tag)];
  }
};

/// What meets itself in other places of the part.
struct PeriodicSeeds {
  /// Pieces of edges that are each other's images have the same points, as far apart as the least spacing
  /// along any of them asks for, but where `given` has others.
  Periodicity periodicity;
  GivenPoints given;
};

}  // namespace octet
