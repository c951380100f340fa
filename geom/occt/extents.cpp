// SPDX-License-Identifier: BSD-3-Clause
// Points on the edges stand for the facets by which a model's own axes are told.
#include "geom/occt/extents.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "geom/occt/measure.h"
#include "geom/own_axes.h"

namespace octet {

Extents::Extents(const ModelParts& parts) : parts_(parts), points_(parts.edges.size()) {
  for (std::size_t e = 1; e < parts.edges.size(); ++e) {
    const auto& [first, last] = parts.edges[e].vertex;
    points_[e].push_back(parts.vertices[first].point);
    for (const Vec3& p : edge_samples(parts, e)) points_[e].push_back(p);
    points_[e].push_back(parts.vertices[last].point);
  }
  if (points_.size() < 2) return;
  axes_ = axes();
  Box3 box;
  for (const auto& points : points_)
    for (const Vec3& p : points) box.add(axes_ * p);
  diagonal_ = box.diagonal();
}

double Extents::diagonal_of(const ModelRegion& region) const {
  Box3 box;
  for (const int face : region.faces)
    for (const FaceBoundary& side : parts_.faces[face].boundary)
      for (const Vec3& p : points_[side.edge]) box.add(axes_ * p);
  return box.diagonal();
}

/// Of what the loops of a planar face enclose.
double Extents::planar_area(const ModelFace& face, const Vec3& normal) const {
  const Vec3 origin = points_[face.boundary.front().edge].front();
  Vec3 twice = Vec3::Zero();
  for (const FaceBoundary& side : face.boundary) {
    const std::vector<Vec3>& points = points_[side.edge];
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      twice += side.sense * (points[i] - origin).cross(points[i + 1] - origin);
  }
  return 0.5 * std::abs(twice.dot(normal));
}

Eigen::Matrix3d Extents::axes() const {
  Landmarks landmarks;
  for (std::size_t f = 1; f < parts_.faces.size(); ++f) {
    const ModelFace& face = parts_.faces[f];
    if (std::string_view(parts_.surfaces[f]->kind()) != "plane" || face.boundary.empty()) continue;
    const Vec3 normal = (face.reversed ? 1.0 : -1.0) * parts_.surfaces[f]->normal(Vec2::Zero());
    landmarks.add_plane(normal, planar_area(face, normal));
  }
  std::vector<Vec3> all;
  for (const auto& points : points_) all.insert(all.end(), points.begin(), points.end());
  const double share = 1.0 / static_cast<double>(all.size());
  for (const Vec3& p : all) landmarks.centre += share * p;
  for (const Vec3& p : all) {
    const Vec3 arm = p - landmarks.centre;
    landmarks.second += share * arm * arm.transpose();
    landmarks.diagonal = std::max(landmarks.diagonal, 2.0 * arm.norm());
  }
  for (std::size_t v = 1; v < parts_.vertices.size(); ++v)
    landmarks.vertices.push_back(parts_.vertices[v].point);
  return own_axes(landmarks);
}

}  // namespace octet
