// SPDX-License-Identifier: BSD-3-Clause
// What the steps of Seeder share: the points so far and what keeps them apart.
#pragma once

#include <vector>

#include "geom/creases.h"
#include "geom/edge_match.h"
#include "octree/point_grid.h"
#include "octree/seeds.h"

namespace octet {

// Shares of the local size, as docs/ARCHITECTURE.md ("Points") has them.
/// Between points in the closure of one face: of a curved one, whose triangles are chords, and of a plane.
inline constexpr double kFaceSpacing = 0.7, kPlaneSpacing = 0.8;
/// Between points within a plane that has room on both sides; from those on its edges they keep the former.
inline constexpr double kWideSpacing = 0.95;
/// Sheets and edges closer than this get matched pairs; sheets of stacks, closer than a thin wall is thick,
/// columns.
inline constexpr double kMatchDistance = 0.7;
/// Cuts are gone through in blocks of space, in parallel, where there are as many; else in their order.
inline constexpr std::size_t kCutsInBlocks = 100'000;

struct SeedState {
  SeedState(const Model& m, const Octree& t, double edge_cell)
      : model(m),
        tree(t),
        points_grid(t.origin(), t.root_size()),
        piece_grid(t.origin(), t.root_size()),
        edge_index(m, edge_cell) {
    seeds.tips = Tips(m, t);
    for (int f = 1; f <= m.count(2); ++f) folded.push_back(meets_itself(m, f));
  }

  const Model& model;
  const Octree& tree;
  Seeds seeds;
  PointGrid points_grid;  ///< all points so far
  PointGrid piece_grid;   ///< midpoints of edge pieces, in cells of the local size or their length
  std::vector<std::uint32_t> long_pieces;  ///< from the ends of tips, far longer than the local size
  EdgeIndex edge_index;
  std::vector<bool> folded{false};  ///< by face tag: it meets itself in an edge

  std::uint32_t add(const Vec3& p, ModelRef on, double spacing) {
    const auto n =
        static_cast<std::uint32_t>(seeds.points.add(p, on, free_point_rank(seeds.points.size()), spacing));
    points_grid.add(n, p, spacing);
    return n;
  }
};

/// One point a model vertex.
void seed_model_vertices(SeedState& state);
/// Points on the real model edges at the local size, in matched pairs; fills `pieces`.
void seed_model_edges(SeedState& state, const SeedOptions& options);
/// Points on the model faces: octant-edge cuts by spacing within the face's closure, in matched
/// pairs and columns.
void seed_model_faces(SeedState& state, const std::vector<OctantEdgeCut>& cuts, const SeedOptions& options);
/// Octree vertices away from the surface; outside ones only in narrow gaps, and pillars for octants of the
/// size asked for everywhere.
void seed_octree_vertices(SeedState& state, const OctreeVertices& vertices, const OctreeLabels& labels,
                          const SeedOptions& options);

}  // namespace octet
