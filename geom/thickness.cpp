// SPDX-License-Identifier: BSD-3-Clause
// Segments from the facets inwards.
#include "geom/thickness.h"

#include <algorithm>

#include "geom/tiny_features.h"

namespace octet {
namespace {

constexpr double kOpposed = 0.866;  // cosine of 30 degrees
constexpr double kTaperThicknesses = 3.0;
constexpr std::size_t kMostPlaces = 10000;  ///< asked on one face, spread over its facets

bool tapers(const Model& model, const Wall& wall) {
  if (wall.face == wall.opposite) return false;
  for (const FaceBoundary& side : model.face(wall.face).boundary) {
    const auto& faces = model.edge(side.edge).faces;
    if (!std::binary_search(faces.begin(), faces.end(), wall.opposite)) continue;
    if (model.edge_closest(side.edge, wall.from).distance < kTaperThicknesses * wall.thickness) return true;
  }
  return false;
}

/// The wall that the segment from a place on `face` into `region` crosses, if it is thinner than `limit`.
std::optional<Wall> wall_at(const Model& model, int face, const Vec2& uv, int side, double limit,
                            std::vector<Hit>& hits) {
  Wall wall;
  wall.face = face;
  wall.region = model.face(face).region[static_cast<std::size_t>(side)];
  if (wall.region == 0) return {};
  wall.from = model.face_jet(face, uv, 0).p;
  const Vec3 inwards = model.face_normal(face, uv) * (side == 0 ? -1.0 : 1.0);
  hits.clear();
  model.intersect(wall.from, wall.from + limit * inwards, hits);
  for (const Hit& hit : hits) {
    wall.thickness = (hit.point - wall.from).norm();
    if (hit.end_point && wall.thickness < 0.5 * limit) continue;  // where the segment starts
    wall.to = hit.point;
    wall.opposite = hit.face;
    const auto& region = model.face(hit.face).region;
    const double outwards = region[0] == wall.region ? 1.0 : -1.0;
    if (region[0] != wall.region && region[1] != wall.region) return {};
    if (outwards * hit.normal.dot(inwards) < kOpposed || tapers(model, wall)) return {};
    return wall;
  }
  return {};
}

}  // namespace

std::optional<Wall> thinnest_wall(const Model& model) {
  std::optional<Wall> thinnest;
  std::vector<Hit> hits;
  const Facets& facets = model.facets();
  // Slivers may have countless facets, and tell nothing of walls.
  std::vector<bool> skipped(static_cast<std::size_t>(model.count(2)) + 1);
  for (int f = 1; f <= model.count(2); ++f) skipped[static_cast<std::size_t>(f)] = is_sliver(model, f);
  std::vector<std::size_t> count(skipped.size()), at(skipped.size());
  for (const int face : facets.face) ++count[static_cast<std::size_t>(face)];
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto face = static_cast<std::size_t>(facets.face[i]);
    const std::size_t step = (count[face] + kMostPlaces - 1) / kMostPlaces;
    if (skipped[face] || at[face]++ % step != 0) continue;
    const Vec2 uv = (facets.uv[i][0] + facets.uv[i][1] + facets.uv[i][2]) / 3.0;
    for (const int side : {0, 1}) {
      const double limit = thinnest ? thinnest->thickness : 1.01 * model.diagonal();
      const auto wall = wall_at(model, facets.face[i], uv, side, limit, hits);
      if (wall && wall->thickness < limit) thinnest = wall;
    }
  }
  return thinnest;
}

}  // namespace octet
