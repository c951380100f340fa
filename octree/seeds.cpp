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

/// How near the boundary each octree vertex is: 0 on a boundary octant, hanging on it included; 1 on an
/// octant that has such a vertex; 2 farther.
std::vector<std::uint8_t> rings(const Octree& tree, const OctreeVertices& vertices,
                                const OctreeLabels& labels) {
  std::vector<std::uint8_t> ring(vertices.size(), 2);
  const auto mark = [&](OctantId o, std::uint8_t value) {
    for (const std::uint32_t v : octant_lattice(tree, vertices, o))
      if (v != UINT32_MAX) ring[v] = std::min(ring[v], value);
  };
  for (std::size_t o = 0; o < tree.size(); ++o)
    if (labels.type[o] == OctantType::kBoundary) mark(OctantId(o), 0);
  std::vector<OctantId> next;
  for (std::size_t o = 0; o < tree.size(); ++o) {
    const auto& corners = vertices.corners[o];
    if (labels.type[o] != OctantType::kBoundary &&
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return ring[v] == 0; }))
      next.emplace_back(o);
  }
  for (const OctantId o : next) mark(o, 1);
  return ring;
}

bool is_root_corner(const Lattice& at) {
  constexpr std::uint32_t kFar = std::uint32_t{1} << kLatticeLevels;
  return std::all_of(at.begin(), at.end(), [](std::uint32_t x) { return x == 0 || x == kFar; });
}

}  // namespace

void seed_octree_vertices(SeedState& state, const OctreeVertices& vertices, const OctreeLabels& labels) {
  Seeds& seeds = state.seeds;
  seeds.octree_vertex_kept.assign(vertices.size(), 0);
  const std::vector<std::uint8_t> ring = rings(state.tree, vertices, labels);
  // Octree vertices are on a lattice of their own spacing: only points placed before them can be too close.
  const std::size_t surface_points = seeds.points.size();
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const int region = labels.vertex_region[v];
    if (region == 0 && ring[v] == 2 && !is_root_corner(vertices.at[v])) continue;
    const Vec3 p = state.tree.position(vertices.at[v]);
    const double clear = kOctreeSpacing * state.tree.length(vertices.finest_level[v]);
    if (ring[v] < 2) {
      if (state.points_grid.any_within(p, clear, [](std::uint32_t, double) { return true; })) continue;
      if (ring[v] == 0 && state.model.closest(p, clear)) continue;
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
