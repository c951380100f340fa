// SPDX-License-Identifier: BSD-3-Clause
// The first point set: by priority and spacing, in matched pairs where sheets face each other.
#pragma once

#include <vector>

#include "base/observer.h"
#include "base/seed_points.h"
#include "octree/cuts.h"

namespace octet {

/// One piece of a model edge between two consecutive points on it.
struct EdgePiece {
  std::uint32_t a = 0, b = 0;  ///< seed numbers
  double ta = 0.0, tb = 0.0;   ///< parameters on the edge, ta < tb
  std::int32_t edge = 0;
};

struct Seeds {
  SeedPoints points;
  std::vector<EdgePiece> pieces;                 ///< every real model edge as a chain, in order
  std::vector<std::uint32_t> model_vertex;       ///< per model vertex tag: its seed number ([0] unused)
  std::vector<std::uint8_t> octree_vertex_kept;  ///< per octree vertex: whether it is a point
};

/// Points by priority: model vertices, model edges, faces (cuts), octree vertices [Schroeder & Shephard 1990,
/// "Element generation"; departures in docs/ARCHITECTURE.md].
[[nodiscard]] Seeds seed_points(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                                const OctreeLabels& labels, Observer& observer);

}  // namespace octet
