// SPDX-License-Identifier: BSD-3-Clause
// Nearest boundary point and the region of a point.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "geom/facet_trim.h"
#include "geom/model_data.h"

namespace octet {
const FacetFoot& nearest_of(const std::vector<FacetFoot>& near) {
  return *std::min_element(near.begin(), near.end(), [](const FacetFoot& a, const FacetFoot& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
  });
}

/// One nearest-point query over all faces or one.
class ClosestQuery {
 public:
  ClosestQuery(const Model::Data& data, const Vec3& p, int face) : data_(data), p_(p), face_(face) {}

  std::optional<Foot> run(double max_distance) {
    std::vector<FacetFoot> near;
    data_.bvh.near(p_, max_distance, face_, near);
    return run(max_distance, std::move(near));
  }
  /// `near`: what FacetBvh::near gives of p.
  std::optional<Foot> run(double max_distance, std::vector<FacetFoot> near) {
    near_ = std::move(near);
    if (near_.empty()) return std::nullopt;
    std::sort(near_.begin(), near_.end(), [&](const FacetFoot& a, const FacetFoot& b) {
      const int fa = face_of(a), fb = face_of(b);
      if (fa != fb) return fa < fb;
      return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
    });
    best_.distance = kInfinity;
    meet_edges();
    meet_poles();
    for (std::size_t begin = 0, end = 0; begin < near_.size(); begin = end) {
      while (end < near_.size() && face_of(near_[end]) == face_of(near_[begin])) ++end;
      meet_face(std::span(near_).subspan(begin, end - begin));
    }
    if (best_.distance == kInfinity) take_untrimmed(nearest_of(near_));
    if (best_.distance > max_distance) return std::nullopt;
    if (best_.on.dim == 2) settle_on_edge();
    if (best_.on.dim == 1) settle_on_vertex(best_.on.tag);
    return best_;
  }

 private:
  [[nodiscard]] int face_of(const FacetFoot& f) const { return data_.facets().face[f.triangle]; }

  void meet_edges() {
    struct Nearest {
      int edge;
      double distance;
      const BorderSide* side;
      std::uint32_t triangle;
      int corner;  ///< opposite the side
    };
    std::vector<Nearest> edges;
    for (const FacetFoot& f : near_)
      for (int corner = 0; corner < 3; ++corner) {
        const std::int32_t s = data_.border.of_triangle[f.triangle][corner];
        if (s < 0) continue;
        const BorderSide& side = data_.border.sides[s];
        const double d = chord_distance(data_, side, p_);
        const auto known =
            std::find_if(edges.begin(), edges.end(), [&](const Nearest& n) { return n.edge == side.edge; });
        if (known == edges.end())
          edges.push_back({side.edge, d, &side, f.triangle, corner});
        else if (d < known->distance)
          *known = {side.edge, d, &side, f.triangle, corner};
      }
    std::sort(edges.begin(), edges.end(), [](const Nearest& a, const Nearest& b) { return a.edge < b.edge; });
    for (const Nearest& n : edges) {
      if (n.distance - n.side->reach > best_.distance) continue;
      const Curve& curve = data_.curve(n.edge);
      const Vec3 x = curve.point(curve.project(p_, n.side->t));
      const double d = (x - p_).norm();
      if (d >= best_.distance) continue;
      best_.point = x;
      best_.distance = d;
      best_.on = model_edge(n.edge);
      set_face(n.triangle, data_.seed_on_side(n.triangle, n.corner, x));
    }
  }

  /// Vertices without edges: poles and apices, where no foot on the surface may converge.
  void meet_poles() {
    for (const FacetFoot& f : near_)
      for (const std::uint32_t node : data_.facets().triangles[f.triangle]) {
        const std::int32_t v = data_.border.node_vertex[node];
        if (v <= 0 || has_real_edge(v)) continue;
        const Vec3& x = data_.parts.vertices[v].point;
        const double d = (x - p_).norm();
        if (d >= best_.distance) continue;
        best_.point = x;
        best_.distance = d;
        best_.on = model_vertex(v);
        set_face(f.triangle, data_.seed(f.triangle));
      }
  }

  [[nodiscard]] bool has_real_edge(int v) const {
    const auto& edges = data_.parts.vertices[v].edges;
    return std::any_of(edges.begin(), edges.end(),
                       [&](int e) { return data_.parts.edges[e].use == EdgeUse::kReal; });
  }

  void set_face(std::uint32_t triangle, const Vec2& seed) {
    best_.face = data_.facets().face[triangle];
    best_.uv = data_.surface(best_.face).project(best_.point, seed).uv;
    best_.normal = data_.normal(best_.face, best_.uv, triangle);
  }

  /// The foot on the untrimmed surface counts when it lies in the face; the first start that converges
  /// near its facet is enough, but for a start on the other side of a face that is thinner than its facets
  /// deviate (a blade beside its end).
  void meet_face(std::span<const FacetFoot> triangles) {
    const int face = face_of(triangles.front());
    constexpr std::size_t kStarts = 4;
    const std::size_t starts = std::min(kStarts, triangles.size());
    std::size_t i = 0;
    Vec3 found = Vec3::Zero();
    for (; i < starts && found.isZero(); ++i) {
      if (triangles[i].distance - data_.bvh.grow(triangles[i].triangle) > best_.distance) return;
      found = meet_face_from(face, triangles[i], triangles);
    }
    if (found.isZero()) return;
    const FacetFoot* start = data_.nearest_against(triangles.subspan(i), found);
    if (start != nullptr && start->distance - data_.bvh.grow(start->triangle) <= best_.distance)
      (void)meet_face_from(face, *start, triangles);
  }

  /// The normal at the foot where it is near the facet, else zero.
  Vec3 meet_face_from(int face, const FacetFoot& start, std::span<const FacetFoot> triangles) {
    const SurfaceFoot foot = data_.surface(face).project(p_, data_.seed(start.triangle, start.weights));
    const double d = (foot.point - p_).norm();
    const bool far_off = !foot.converged || d > start.distance + data_.bvh.grow(start.triangle);
    const Vec3 normal = data_.normal(face, foot.uv, start.triangle);
    if (d < best_.distance && in_face(face, foot, triangles)) {
      best_.point = foot.point;
      best_.distance = d;
      best_.on = model_face(face);
      best_.face = face;
      best_.uv = foot.uv;
      best_.normal = normal;
    }
    return far_off ? Vec3(Vec3::Zero()) : normal;
  }

  [[nodiscard]] bool in_face(int face, const SurfaceFoot& foot, std::span<const FacetFoot> triangles) const {
    const auto id = [](const FacetFoot& f) { return f.triangle; };
    return clearly_in_facets(data_, foot.point, foot.uv, triangles.begin(), triangles.end(), id) ||
           data_.parts.trims[face]->side(foot.uv) != TrimSide::kOut;
  }

  /// No face holds its foot and no edge is near: trims and facets disagree (a seam, a pole).
  void take_untrimmed(const FacetFoot& start) {
    const int face = face_of(start);
    const SurfaceFoot foot = data_.surface(face).project(p_, data_.seed(start.triangle, start.weights));
    best_.point = foot.point;
    best_.distance = (foot.point - p_).norm();
    best_.on = model_face(face);
    best_.face = face;
    best_.uv = foot.uv;
    best_.normal = data_.normal(face, foot.uv, start.triangle);
  }

  void settle_on_edge() {
    for (const FacetFoot& f : near_) {
      if (face_of(f) != best_.face) continue;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = data_.border.node_vertex[data_.facets().triangles[f.triangle][k]];
        if (v > 0 && settle(v)) return;
        const std::int32_t s = data_.border.of_triangle[f.triangle][k];
        if (s < 0) continue;
        const BorderSide& side = data_.border.sides[s];
        const double reach = data_.edge_reach(side.edge);
        if (chord_distance(data_, side, best_.point) > side.reach) continue;
        const Curve& curve = data_.curve(side.edge);
        const Vec3 x = curve.point(curve.project(best_.point, side.t));
        if ((x - best_.point).norm() > reach) continue;
        best_.on = model_edge(side.edge);
        return;
      }
    }
  }

  void settle_on_vertex(int edge) {
    for (const int v : data_.parts.edges[edge].vertex)
      if (settle(v)) return;
  }

  bool settle(int v) {
    if ((data_.parts.vertices[v].point - best_.point).norm() > data_.vertex_reach(v)) return false;
    best_.on = model_vertex(v);
    return true;
  }

  const Model::Data& data_;
  Vec3 p_;
  int face_;
  std::vector<FacetFoot> near_;
  Foot best_;
};

std::optional<Foot> Model::closest(const Vec3& p, double max_distance) const {
  return ClosestQuery(*data_, p, 0).run(max_distance);
}

std::optional<Foot> closest_of(const Model::Data& data, const Vec3& p, std::vector<FacetFoot> near) {
  return ClosestQuery(data, p, 0).run(kInfinity, std::move(near));
}

Foot Model::face_closest(int tag, const Vec3& p) const {
  const auto foot = ClosestQuery(*data_, p, tag).run(1e100);
  return foot ? *foot : Foot{};
}

}  // namespace octet
