// SPDX-License-Identifier: BSD-3-Clause
// What a Model holds; for the .cpp files of geom/ only.
#pragma once

#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include "geom/arc_length.h"
#include "geom/border_sides.h"
#include "geom/curve_samples.h"
#include "geom/face_crossings.h"
#include "geom/facet_bvh.h"
#include "geom/model.h"
#include "geom/region_grid.h"

namespace octet {

struct Model::Data {
  ModelParts parts;
  std::vector<bool> is_plane;         ///< per face
  std::vector<ArcLength> arcs;        ///< per edge; empty for degenerate edges
  std::vector<CurveSamples> samples;  ///< per edge
  BorderSides border;
  FacetBvh bvh;
  Box3 box;
  double diagonal = 0.0, tolerance = 0.0;

  mutable std::vector<FaceCrossing> crossings;  ///< once they are looked for
  mutable std::once_flag crossings_begun;

  /// Made when it is first asked for: a part that is only read and turned has none.
  mutable RegionGrid made_grid;
  mutable std::once_flag grid_begun;
  mutable std::atomic<bool> grid_made{false};

  /// Empty until it is made; the answers are the same, for then all are the exact ones.
  [[nodiscard]] const RegionGrid& grid() const {
    static const RegionGrid kNone;
    return grid_made.load(std::memory_order_acquire) ? made_grid : kNone;
  }
  [[nodiscard]] const Facets& facets() const { return parts.facets; }
  [[nodiscard]] const Surface& surface(int face) const { return *parts.surfaces[face]; }
  [[nodiscard]] const Curve& curve(int edge) const { return *parts.curves[edge]; }
  [[nodiscard]] double edge_reach(int edge) const { return parts.edges[edge].tolerance + tolerance; }
  [[nodiscard]] double vertex_reach(int vertex) const { return parts.vertices[vertex].tolerance + tolerance; }

  /// (u,v) at a point of a triangle; linear, so a seed only.
  [[nodiscard]] Vec2 seed(std::uint32_t triangle, const Vec3& weights) const {
    const auto& uv = parts.facets.uv[triangle];
    return weights[0] * uv[0] + weights[1] * uv[1] + weights[2] * uv[2];
  }
  [[nodiscard]] Vec2 seed(std::uint32_t triangle) const { return seed(triangle, Vec3::Constant(1.0 / 3.0)); }
  /// The same where its side opposite the corner comes nearest to x.
  [[nodiscard]] Vec2 seed_on_side(std::uint32_t triangle, int corner, const Vec3& x) const;
  /// Unit normal of the face at the place x of one of its edges. The face's nearest facet may be of another
  /// side of it, where the face comes back beside the edge nearer than its facets deviate (the end of a
  /// blade).
  [[nodiscard]] Vec3 normal_on_edge(int face, int edge, const Vec3& x) const;

  /// Unit normal of the face, towards region[1]; that of the facet where the surface has none.
  [[nodiscard]] Vec3 normal(int face, const Vec2& uv, std::uint32_t triangle) const;
  /// Unit normal of the face, zero where the surface has none.
  [[nodiscard]] Vec3 normal(int face, const Vec2& uv) const {
    const Vec3 n = parts.surfaces[face]->normal(uv);
    return parts.faces[face].reversed ? Vec3(-n) : n;
  }
  [[nodiscard]] Vec3 facet_normal(std::uint32_t triangle) const;
  /// The nearest of facets of one face whose normal is against `normal`, that of a foot found from another:
  /// where the face is thinner than its facets deviate, the foot may be on its wrong side. Null where there
  /// is none.
  [[nodiscard]] const FacetFoot* nearest_against(std::span<const FacetFoot> near, const Vec3& normal) const;
  /// Side of a region boundary on which `p` lies.
  [[nodiscard]] int region_beside(int face, double height) const {
    return parts.faces[face].region[height > 0.0 ? 1 : 0];
  }
};

/// The nearest of what FacetBvh::near gives, of equals the lowest triangle.
const FacetFoot& nearest_of(const std::vector<FacetFoot>& near);

/// Model::closest() where what FacetBvh::near gives of p is known already.
std::optional<Foot> closest_of(const Model::Data& data, const Vec3& p, std::vector<FacetFoot> near);

/// Model::intersect() without the questions of regions that settle the kind of events at vertices and where
/// a face is grazed on an edge; for region_at() itself.
void intersect_unsettled(const Model::Data& data, const Vec3& p, const Vec3& q, std::vector<Hit>& hits);

}  // namespace octet
