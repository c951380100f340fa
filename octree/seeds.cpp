// SPDX-License-Identifier: BSD-3-Clause
// The first point set, step by step.
#include "octree/seeds.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "base/sort_unique.h"
#include "geom/facet_bvh.h"
#include "octree/even_walls.h"
#include "octree/interior.h"
#include "octree/seed_state.h"

namespace octet {

Seeder::Seeder(const Model& model, const Octree& tree, const SeedOptions& options)
    : options_(options), state_(std::make_unique<SeedState>(model, tree, options.size)) {}

Seeder::~Seeder() = default;

void Seeder::seed_boundary(const std::vector<OctantEdgeCut>& cuts) {
  seed_model_vertices(*state_);
  seed_model_edges(*state_, options_);
  seed_model_faces(*state_, cuts, options_);
}

Seeds Seeder::seed_octree(const OctreeVertices& vertices, const OctreeLabels& labels) {
  seed_octree_vertices(*state_, vertices, labels, options_);
  return std::move(state_->seeds);
}

void seed_model_vertices(SeedState& state) {
  state.seeds.model_vertex.assign(static_cast<std::size_t>(state.model.count(0)) + 1, 0);
  for (int v = 1; v <= state.model.count(0); ++v) {
    const Vec3 p = state.model.vertex(v).point;
    state.seeds.model_vertex[v] = state.add(p, model_vertex(v), state.tree.spacing_at(p));
  }
}

namespace {

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
  std::vector<std::uint8_t>& ring = result.ring;
  std::vector<std::uint8_t>& open = result.open;
  for (std::size_t o = 0; o < tree.size(); ++o)
    if (labels.type[o] == OctantType::kBoundary)
      for_each_vertex(vertices, OctantId(o), [&](std::uint32_t v) { ring[v] = 0; });
  for (std::size_t o = 0; o < tree.size(); ++o) {
    const auto& corners = vertices.corners[o];
    if (labels.type[o] == OctantType::kBoundary ||
        std::none_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return ring[v] == 0; }))
      continue;
    const bool outside = labels.type[o] == OctantType::kOut;
    for_each_vertex(vertices, OctantId(o), [&](std::uint32_t v) {
      ring[v] = std::min<std::uint8_t>(ring[v], 1);
      open[v] |= outside ? 1 : 0;
    });
  }
  // Centres of boundary octants lie on no other octant: they are as open as the corners.
  for (std::size_t o = 0; o < tree.size(); ++o) {
    const auto& corners = vertices.corners[o];
    if (labels.type[o] == OctantType::kBoundary &&
        std::any_of(corners.begin(), corners.end(),
                    [&, &open = open](std::uint32_t v) { return open[v] != 0; }))
      open[vertices.centre(OctantId(o))] = 1;
  }
  return result;
}

}  // namespace

namespace {

/// Where the CAD does not know on which side of its boundary a place lies: within an edge's corridor or a
/// vertex's ball of twice its tolerance. An octree vertex there would say what cannot be said.
class Vagueness {
 public:
  explicit Vagueness(const Model& model) : model_(model), reach_(model.count(2) + 1, 0.0) {
    for (int f = 1; f <= model.count(2); ++f) {
      double& reach = reach_[static_cast<std::size_t>(f)];
      for (const int v : model.face(f).vertices) reach = std::max(reach, reach_of(model_vertex(v)));
      for (const FaceBoundary& side : model.face(f).boundary)
        reach = std::max(reach, reach_of(model_edge(side.edge)));
      widest_ = std::max(widest_, reach);
    }
  }

  /// Whether p is vague, of places that keep `clear` from the boundary.
  [[nodiscard]] bool covers(const Vec3& p, double clear) const {
    if (widest_ <= clear) return false;
    std::vector<int> faces;
    model_.bvh().visit_within(p, widest_, 0, [&](const FacetFoot& foot) {
      const int face = model_.facets().face[foot.triangle];
      if (reach_[static_cast<std::size_t>(face)] > clear) faces.push_back(face);
    });
    sort_unique(faces);
    return std::any_of(faces.begin(), faces.end(), [&](int f) { return has_it_at_its_border(f, p, clear); });
  }

 private:
  [[nodiscard]] double reach_of(ModelRef entity) const { return 2.0 * model_.tolerance_of(entity); }

  [[nodiscard]] bool has_it_at_its_border(int f, const Vec3& p, double clear) const {
    const ModelFace& face = model_.face(f);
    const auto in_ball = [&](int v) {
      return (p - model_.vertex(v).point).norm() < reach_of(model_vertex(v));
    };
    const auto in_corridor = [&](const FaceBoundary& side) {
      const double reach = reach_of(model_edge(side.edge));
      return reach > clear && model_.edge_closest(side.edge, p).distance < reach;
    };
    return std::any_of(face.vertices.begin(), face.vertices.end(), in_ball) ||
           std::any_of(face.boundary.begin(), face.boundary.end(), in_corridor);
  }

  const Model& model_;
  std::vector<double> reach_;  ///< per face: the widest at its border
  double widest_ = 0.0;
};

/// A wall of no more spacings: the layer of octree vertices in its middle stands or not by chance unless they
/// may be near to its faces. One that is thin (kThinWall) has none: its elements, all of them from one sheet
/// to the other, are better than those of two flat layers, and a third fewer.
constexpr double kWall = 3.5;

/// Whether p, whose nearest place on the surface is given, has the surface also on its other side, within a
/// wall's thickness, which is more than p's distance.
bool is_in_wall(const Model& model, const Vec3& p, const Foot& surface, double thickness) {
  const Vec3 across = (thickness - surface.distance) * (p - surface.point) / surface.distance;
  bool met = false;
  model.bvh().visit_segment(p, p + across, [&](std::uint32_t) { met = true; });
  return met;
}

}  // namespace

void seed_octree_vertices(SeedState& state, const OctreeVertices& vertices, const OctreeLabels& labels,
                          const SeedOptions& options) {
  const Lattice::value_type spacing = pillar_spacing(state.tree, options.size);
  Seeds& seeds = state.seeds;
  const Surroundings around = surroundings(state.tree, vertices, labels);
  const std::vector<std::uint8_t>& ring = around.ring;
  const std::vector<std::uint8_t>& open = around.open;
  const Vagueness vagueness(state.model);
  const auto spacing_at = [&](std::uint32_t v) {
    return kSpacingPerOctant * state.tree.length(vertices.finest_level[v]);
  };
  const auto is_vague = [&](std::uint32_t v) {
    return vagueness.covers(state.tree.position(vertices.at[v]), options.octree_clearance * spacing_at(v));
  };
  // Pieces that the user asks for may be longer than points are apart.
  const auto is_beside_piece = [&](const Vec3& p, double spacing) {
    return !options.divisions.empty() &&
           state.piece_grid.any_around(p, 2.0 * spacing, [&](std::uint32_t n, double) {
             const EdgePiece& piece = seeds.pieces[n];
             return options.divisions[static_cast<std::size_t>(piece.edge)] > 0 &&
                    (p - seeds.points.position[piece.a]).dot(p - seeds.points.position[piece.b]) < 0.0;
           });
  };
  // Octree vertices are on a lattice of their own spacing: only points placed before them can be too close.
  const auto is_clear = [&](std::uint32_t v) {
    const Vec3 p = state.tree.position(vertices.at[v]);
    const double spacing = spacing_at(v), clear = options.octree_clearance * spacing;
    const double open_clear = std::max(options.octree_clearance, options.open_clearance) * spacing;
    const double reach = std::max(open_clear, 0.5 * kThinWall * spacing);
    const std::optional<Foot> surface = ring[v] == 0 ? state.model.closest(p, reach) : std::nullopt;
    const auto is_crowded = [&](double clearance) {
      return (surface && surface->distance < clearance) ||
             state.points_grid.any_within(p, clearance, [](std::uint32_t, double) { return true; });
    };
    const auto is_in_material = [&](double thickness) {
      return labels.vertex_region[v] != 0 && surface &&
             is_in_wall(state.model, p, *surface, thickness * spacing);
    };
    if (is_crowded(clear) || is_vague(v) || is_beside_piece(p, spacing) || is_in_material(kThinWall))
      return false;
    return !is_crowded(open_clear) || is_in_material(kWall);
  };
  std::vector<std::uint8_t>& kept = seeds.octree_vertex_kept;
  kept.assign(vertices.size(), 0);
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(vertices.size()), [&](std::uint32_t v) {
    // Outside, those in narrow gaps and small voids tell what lies there; along open ground none is needed.
    const bool wanted =
        labels.vertex_region[v] != 0 || (ring[v] == 0 && open[v] == 0) || is_pillar(vertices.at[v], spacing);
    if (wanted && seeds.tips.are_beside(state.tree.position(vertices.at[v]))) return;
    kept[v] = wanted && (ring[v] == 2 ? !is_vague(v) : is_clear(v)) ? 1 : 0;
  });
  seeds.surface_points = seeds.points.size();
  seeds.octree_point.assign(vertices.size(), UINT32_MAX);
  std::uint32_t count = static_cast<std::uint32_t>(seeds.surface_points);
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (kept[v] != 0) seeds.octree_point[v] = count++;
  seeds.points.resize(count);
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(vertices.size()), [&](std::uint32_t v) {
    if (kept[v] == 0) return;
    seeds.points.set(seeds.octree_point[v], state.tree.position(vertices.at[v]),
                     model_region(labels.vertex_region[v]), vertices.rank(v), spacing_at(v));
  });
}

}  // namespace octet
