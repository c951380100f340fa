// SPDX-License-Identifier: BSD-3-Clause
// Points on model faces: the exact cuts of octant edges, thinned by spacing, in matched pairs.
#include <optional>

#include "base/error.h"
#include "geom/face_match.h"
#include "geom/opposite.h"
#include "octree/seed_state.h"

namespace octet {
namespace {

struct FacePoint {
  Vec3 p;
  int face;
  double size;
};

class FaceSeeder {
 public:
  explicit FaceSeeder(SeedState& state) : state_(state), model_(state.model) {}

  /// A vertex or edge that comes close to a face it does not bound gets a partner on that face.
  void match_vertices_and_edges() {
    for (int v = 1; v <= model_.count(0); ++v) match(state_.seeds.model_vertex[v], Vec3::Zero());
    for (const EdgePiece& piece : state_.seeds.pieces)
      if (state_.seeds.points.on[piece.b].dim == 1)
        match(piece.b, model_.edge_derivative(piece.edge, piece.tb));
  }

  /// The rings of sharp tips.
  void add_rings() {
    for (const Tip& tip : state_.seeds.tips.all())
      for (const Vec3& place : ring_places(tip))
        for (const int face : tip.faces) {
          const std::optional<Vec3> p = ring_point(model_, tip, face, place);
          if (!p) continue;
          const FacePoint a{*p, face, ring_spacing(tip)};
          if (is_free(a)) add(a);
        }
  }

  void offer(const Hit& hit) {
    if (hit.on.dim != 2 || hit.kind != HitKind::kTransversal) return;
    if (state_.seeds.tips.holder(hit.on.tag, hit.point)) return;
    const FacePoint a{hit.point, hit.on.tag, state_.tree.spacing_at(hit.point)};
    if (!is_free(a)) return;
    std::vector<FacePoint> partners;
    for (const int side : {-1, 1}) {
      const std::optional<FacePoint> b = partner(a, hit.normal, side);
      if (!b) continue;
      if (!is_free(*b)) return;  // a pair goes in whole or not at all
      partners.push_back(*b);
    }
    add(a);
    for (const FacePoint& b : partners)
      if (is_free(b)) add(b);
  }

 private:
  void match(std::uint32_t point, const Vec3& tangent) {
    const ModelRef on = state_.seeds.points.on[point];
    const Vec3 a = state_.seeds.points.position[point];
    const double size = state_.tree.spacing_at(a);
    for (const FacePartner& partner : face_partners(model_, on, a, tangent, kMatchDistance * size)) {
      const FacePoint b{partner.point, partner.face, size};
      if (is_free(b)) add(b);
    }
  }

  void add(const FacePoint& a) { state_.add(a.p, model_face(a.face), a.size); }

  /// Far enough from the points of the same face's closure, and outside the diametral ball of every edge
  /// piece.
  [[nodiscard]] bool is_free(const FacePoint& a) const {
    const ModelRef face = model_face(a.face);
    const double spacing = (model_.is_plane(a.face) ? kPlaneSpacing : kFaceSpacing) * a.size;
    const SeedPoints& points = state_.seeds.points;
    if (state_.points_grid.any_within(
            a.p, spacing, [&](std::uint32_t n, double) { return model_.in_closure(points.on[n], face); }))
      return false;
    return !state_.piece_grid.any_within(a.p, a.size, [&](std::uint32_t n, double) {
      const EdgePiece& piece = state_.seeds.pieces[n];
      return (a.p - points.position[piece.a]).dot(a.p - points.position[piece.b]) < 0.0;
    });
  }

  [[nodiscard]] std::optional<FacePoint> partner(const FacePoint& a, const Vec3& normal, int side) const {
    const double reach = kMatchDistance * a.size;
    const std::optional<Foot> foot = facing_point(model_, a.p, a.face, normal, side, reach);
    if (!foot) return std::nullopt;
    return FacePoint{foot->point, foot->on.tag, a.size};
  }

  SeedState& state_;
  const Model& model_;
};

}  // namespace

void seed_model_faces(SeedState& state, const std::vector<OctantEdgeCut>& cuts,
                      const std::function<bool()>& cancelled) {
  constexpr std::size_t kCutsAQuestion = 4096;
  FaceSeeder seeder(state);
  seeder.match_vertices_and_edges();
  seeder.add_rings();
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (i % kCutsAQuestion == 0 && cancelled && cancelled()) throw Cancelled();
    seeder.offer(cuts[i].hit);
  }
}

}  // namespace octet
