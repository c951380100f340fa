// SPDX-License-Identifier: BSD-3-Clause
// The first point set, step by step.
#include "octree/seeds.h"

#include <algorithm>

#include "octree/seed_state.h"

namespace octet {

Seeds seed_points(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                  const OctreeLabels& labels, const std::vector<OctantEdgeCut>& cuts, double size) {
  SeedState state(model, tree, size);
  seed_model_vertices(state);
  seed_model_edges(state);
  seed_model_faces(state, cuts);
  seed_octree_vertices(state, vertices, labels);
  return std::move(state.seeds);
}

void seed_model_vertices(SeedState& state) {
  state.seeds.model_vertex.assign(static_cast<std::size_t>(state.model.count(0)) + 1, 0);
  for (int v = 1; v <= state.model.count(0); ++v) {
    const Vec3 p = state.model.vertex(v).point;
    state.seeds.model_vertex[v] = state.add(p, model_vertex(v), state.tree.size_at(p));
  }
}

namespace {

/// Finest spacing at an octree vertex, and how near the boundary it is: 0 a corner of a boundary octant,
/// 1 a corner of an octant that has such a corner, 2 farther.
struct VertexSurroundings {
  std::vector<std::uint8_t> ring;
};

VertexSurroundings surroundings(const OctreeVertices& vertices, const OctreeLabels& labels) {
  VertexSurroundings result;
  result.ring.assign(vertices.size(), 2);
  for (std::size_t o = 0; o < vertices.corners.size(); ++o)
    if (labels.type[o] == OctantType::kBoundary)
      for (const std::uint32_t v : vertices.corners[o]) result.ring[v] = 0;
  std::vector<std::uint32_t> next;
  for (const auto& corners : vertices.corners)
    if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return result.ring[v] == 0; }))
      next.insert(next.end(), corners.begin(), corners.end());
  for (const std::uint32_t v : next)
    if (result.ring[v] == 2) result.ring[v] = 1;
  return result;
}

bool is_root_corner(const Lattice& at) {
  constexpr std::uint32_t kFar = std::uint32_t{1} << kLatticeLevels;
  return std::all_of(at.begin(), at.end(), [](std::uint32_t x) { return x == 0 || x == kFar; });
}

}  // namespace

void seed_octree_vertices(SeedState& state, const OctreeVertices& vertices, const OctreeLabels& labels) {
  Seeds& seeds = state.seeds;
  seeds.octree_vertex_kept.assign(vertices.size(), 0);
  const VertexSurroundings around = surroundings(vertices, labels);
  // Octree vertices are on a lattice of their own spacing: only points placed before them can be too close.
  const std::size_t surface_points = seeds.points.size();
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const int region = labels.vertex_region[v];
    if (region == 0 && around.ring[v] == 2 && !is_root_corner(vertices.at[v])) continue;
    const Vec3 p = state.tree.position(vertices.at[v]);
    const double clear = kOctreeSpacing * state.tree.length(vertices.finest_level[v]);
    if (around.ring[v] < 2) {
      if (state.points_grid.any_within(p, clear, [](std::uint32_t, double) { return true; })) continue;
      if (around.ring[v] == 0 && state.model.closest(p, clear)) continue;
    }
    kept.push_back(v);
  }
  seeds.octree_point.assign(vertices.size(), UINT32_MAX);
  for (const std::uint32_t v : kept) {
    seeds.octree_vertex_kept[v] = 1;
    const double length = state.tree.length(vertices.finest_level[v]);
    seeds.octree_point[v] = static_cast<std::uint32_t>(seeds.points.add(state.tree.position(vertices.at[v]),
                                                                        model_region(labels.vertex_region[v]),
                                                                        vertices.rank(v), length));
  }
  seeds.surface_points = surface_points;
}

}  // namespace octet
