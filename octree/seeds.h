// SPDX-License-Identifier: BSD-3-Clause
// The first point set: by priority and spacing, in matched pairs and columns where sheets face
// each other.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/seed_points.h"
#include "octree/cuts.h"
#include "octree/given_points.h"
#include "octree/labels.h"
#include "octree/tips.h"

namespace octet {

struct Seeds {
  SeedPoints points;                             ///< surface points first, then octree vertices
  std::vector<EdgePiece> pieces;                 ///< every real model edge as a chain, in order
  std::vector<std::uint32_t> model_vertex;       ///< per model vertex tag: its seed number ([0] unused)
  std::size_t surface_points = 0;                ///< points below this number lie on the boundary
  std::vector<std::uint8_t> octree_vertex_kept;  ///< per octree vertex: whether it is a point
  std::vector<std::uint32_t> octree_point;  ///< per octree vertex: its seed number, UINT32_MAX when dropped
  Tips tips;                                ///< where points keep to a ring
};

struct SeedOptions {
  double size = 0.0;  ///< the size asked for
  /// Between an octree vertex and the surface or another point, in local sizes: where a wall ends near by,
  /// and elsewhere.
  double octree_clearance = 0.4, open_clearance = 0.55;
  /// Per model edge ([0] unused), or empty: how many equal pieces it is to have; 0: by the local size.
  std::vector<int> divisions = {};
  const PeriodicSeeds* periodic = nullptr;  ///< referred to; none: nothing is
  std::function<bool()> cancelled = {};     ///< as in cut_octant_edges()
};

struct SeedState;

/// Points by priority, in two steps: those on the boundary (model vertices, model edges, faces), then the
/// octree's vertices [Schroeder & Shephard 1990, "Octant element generation"; Handbook 15.5.2.2; departures
/// in docs/ARCHITECTURE.md]. `model` and `tree` are referred to until the second step.
class Seeder {
 public:
  Seeder(const Model& model, const Octree& tree, const SeedOptions& options);
  ~Seeder();
  Seeder(const Seeder&) = delete;
  Seeder& operator=(const Seeder&) = delete;

  void seed_boundary(const std::vector<OctantEdgeCut>& cuts);
  [[nodiscard]] Seeds seed_octree(const OctreeVertices& vertices, const OctreeLabels& labels);

 private:
  SeedOptions options_;
  std::unique_ptr<SeedState> state_;
};

}  // namespace octet
