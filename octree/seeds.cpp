// SPDX-License-Identifier: BSD-3-Clause
// The first point set, step by step.
#include "octree/seeds.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "octree/interior.h"
#include "octree/seed_state.h"

namespace octet {

Seeds seed_points(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                  const OctreeLabels& labels, const std::vector<OctantEdgeCut>& cuts, double size) {
  SeedState state(model, tree, size);
  seed_model_vertices(state);
  seed_model_edges(state);
  seed_model_faces(state, cuts);
  seed_octree_vertices(state, vertices, labels, size);
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

/// Calls mark(vertex) for every vertex on the octant, those that hang on it included.
template <class Mark>
void for_each_vertex(const Octree& tree, const OctreeVertices& vertices, OctantId o, const Mark& mark) {
  for (const std::uint32_t v : octant_lattice(tree, vertices, o))
    if (v != kNoVertex) mark(v);
}

/// Where each octree vertex is, as far as the boundary goes.
struct Surroundings {
  /// 0 on a boundary octant, hanging on it included; 1 on an octant that has such a vertex; 2 farther.
  std::vector<std::uint8_t> ring;
  /// Of the first ring: whether it is on an outside octant.
  std::vector<std::uint8_t> open;
};

Surroundings surroundings(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels) {
  Surroundings result{std::vector<std::uint8_t>(vertices.size(), 2),
                      std::vector<std::uint8_t>(vertices.size(), 0)};
  auto& [ring, open] = result;
  for (std::size_t o = 0; o < tree.size(); ++o)
    if (labels.type[o] == OctantType::kBoundary)
      for_each_vertex(tree, vertices, OctantId(o), [&](std::uint32_t v) { ring[v] = 0; });
  for (std::size_t o = 0; o < tree.size(); ++o) {
    const auto& corners = vertices.corners[o];
    if (labels.type[o] == OctantType::kBoundary ||
        std::none_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return ring[v] == 0; }))
      continue;
    const bool outside = labels.type[o] == OctantType::kOut;
    for_each_vertex(tree, vertices, OctantId(o), [&](std::uint32_t v) {
      ring[v] = std::min<std::uint8_t>(ring[v], 1);
      open[v] |= outside ? 1 : 0;
    });
  }
  return result;
}

}  // namespace

void seed_octree_vertices(SeedState& state, const OctreeVertices& vertices, const OctreeLabels& labels,
                          double length) {
  const Lattice::value_type spacing = pillar_spacing(state.tree, length);
  Seeds& seeds = state.seeds;
  const auto [ring, open] = surroundings(state.tree, vertices, labels);
  // Octree vertices are on a lattice of their own spacing: only points placed before them can be too close.
  const auto is_clear = [&, &ring = ring](std::uint32_t v) {
    const Vec3 p = state.tree.position(vertices.at[v]);
    const double clear = kOctreeSpacing * state.tree.length(vertices.finest_level[v]);
    return !state.points_grid.any_within(p, clear, [](std::uint32_t, double) { return true; }) &&
           !(ring[v] == 0 && state.model.closest(p, clear));
  };
  std::vector<std::uint8_t>& kept = seeds.octree_vertex_kept;
  kept.assign(vertices.size(), 0);
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(vertices.size()), [&](std::uint32_t v) {
    // Outside, those in narrow gaps and small voids tell what lies there; along open ground none is needed.
    const bool wanted =
        labels.vertex_region[v] != 0 || (ring[v] == 0 && open[v] == 0) || is_pillar(vertices.at[v], spacing);
    kept[v] = wanted && (ring[v] == 2 || is_clear(v)) ? 1 : 0;
  });
  seeds.surface_points = seeds.points.size();
  seeds.octree_point.assign(vertices.size(), UINT32_MAX);
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (kept[v] == 0) continue;
    const double length = state.tree.length(vertices.finest_level[v]);
    seeds.octree_point[v] = static_cast<std::uint32_t>(seeds.points.add(state.tree.position(vertices.at[v]),
                                                                        model_region(labels.vertex_region[v]),
                                                                        vertices.rank(v), length));
  }
}

}  // namespace octet
