// SPDX-License-Identifier: BSD-3-Clause
// Planes, then moments, then vertices; signs by the order of entities, which turns with the part, too.
#include "geom/own_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace octet {
namespace {

constexpr double kSame = 1e-6;        ///< areas and lengths that differ by less are equal
constexpr double kAngle = 1e-5;       ///< directions that differ by less are one; radians
constexpr double kOnAxis = 1e-9;      ///< the same for a direction and a coordinate axis
constexpr double kSameMoment = 1e-3;  ///< moments of no direction of their own

/// Of the surface, about its centroid, per area.
void add_moments(const Facets& facets, Landmarks& landmarks) {
  double area = 0.0;
  for (const bool centred : {false, true}) {
    if (centred) landmarks.centre /= area;
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      const auto [a, b, c] = facet_corners(facets, t);
      const double weight = triangle_area(a, b, c);
      if (!centred) {
        area += weight;
        landmarks.centre += weight * (a + b + c) / 3.0;
        continue;
      }
      const Vec3 sum = a + b + c - 3.0 * landmarks.centre;
      landmarks.second += weight / 12.0 * sum * sum.transpose();
      for (const Vec3& corner : {a, b, c})
        landmarks.second +=
            weight / 12.0 * (corner - landmarks.centre) * (corner - landmarks.centre).transpose();
    }
  }
  landmarks.second /= area;
}

void add_planes(const Model& model, Landmarks& landmarks) {
  std::vector<bool> seen(static_cast<std::size_t>(model.count(2)) + 1);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const int face = facets.face[t];
    if (seen[static_cast<std::size_t>(face)]) continue;
    seen[static_cast<std::size_t>(face)] = true;
    if (std::string_view(model.surface(face).kind()) != "plane") continue;
    // Mostly into the part: from low to high.
    landmarks.add_plane(-model.face_normal(face, facets.uv[t][0]), std::abs(model.face(face).area));
  }
}

Landmarks landmarks_of(const Model& model) {
  Landmarks landmarks;
  add_planes(model, landmarks);
  add_moments(model.facets(), landmarks);
  for (int v = 1; v <= model.count(0); ++v) landmarks.vertices.push_back(model.vertex(v).point);
  landmarks.diagonal = model.diagonal();
  return landmarks;
}

/// The direction of the most area, at right angles to `axis` where that is not zero.
std::optional<Vec3> main_direction(const std::vector<PlaneDirection>& directions, const Vec3& axis) {
  const PlaneDirection* best = nullptr;
  for (const PlaneDirection& d : directions)
    if (std::abs(d.normal.dot(axis)) < kAngle && (!best || d.area > (1.0 + kSame) * best->area)) best = &d;
  return best ? std::optional(best->normal) : std::nullopt;
}

/// The eigenvector of a moment that no other one equals, the largest first.
std::optional<Vec3> single_moment(const Eigen::Matrix3d& second, int dimensions) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);  // ascending
  const Vec3 moment = solver.eigenvalues();
  const double close = kSameMoment * moment[2];
  if (moment[2] - moment[1] > close) return solver.eigenvectors().col(2);
  if (dimensions == 3 && moment[1] - moment[0] > close) return solver.eigenvectors().col(0);
  return std::nullopt;
}

/// From the centre to the vertex that is farthest from the axis through it, at right angles to the axis; zero
/// where all are on it.
Vec3 farthest_vertex(const Landmarks& landmarks, const Vec3& axis) {
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& vertex : landmarks.vertices) {
    const Vec3 d = vertex - landmarks.centre, aside = d - d.dot(axis) * axis;
    if (aside.norm() > (1.0 + kSame) * farthest.norm() + kSame * landmarks.diagonal) farthest = aside;
  }
  return farthest;
}

/// At right angles to a unit vector.
Vec3 aside_of(const Vec3& v, const Vec3& axis) { return (v - v.dot(axis) * axis).normalized(); }

/// Exactly along a coordinate axis where it is so within rounding.
Vec3 snapped(Vec3 axis) {
  for (double& x : axis)
    if (std::abs(x) < kOnAxis) x = 0.0;
  return axis.normalized();
}

/// A moment tells a line; the vertex tells its direction.
Vec3 towards(const Vec3& landmark, const Vec3& axis) { return landmark.dot(axis) < 0.0 ? Vec3(-axis) : axis; }

Vec3 first_axis(const Landmarks& landmarks) {
  if (const auto normal = main_direction(landmarks.planes, Vec3::Zero())) return *normal;
  const auto axis = single_moment(landmarks.second, 3);
  return axis ? towards(farthest_vertex(landmarks, Vec3::Zero()), *axis) : Vec3(Vec3::Zero());
}

Vec3 second_axis(const Landmarks& landmarks, const Vec3& first) {
  if (const auto normal = main_direction(landmarks.planes, first)) return *normal;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - first * first.transpose();
  const Vec3 landmark = farthest_vertex(landmarks, first);
  if (const auto axis = single_moment(across * landmarks.second * across, 2)) return towards(landmark, *axis);
  if (landmark.norm() > 0.0) return landmark.normalized();
  Eigen::Index least = 0;
  first.cwiseAbs().minCoeff(&least);
  return across * Vec3::Unit(least);
}

}  // namespace

void Landmarks::add_plane(const Vec3& normal, double area) {
  constexpr std::size_t kMost = 256;
  auto known = std::find_if(planes.begin(), planes.end(),
                            [&](const PlaneDirection& d) { return d.normal.cross(normal).norm() < kAngle; });
  if (known == planes.end()) {
    if (planes.size() == kMost) return;
    known = planes.insert(known, {normal, 0.0});
  }
  known->area += area;
}

Eigen::Matrix3d own_axes(const Model& model) { return own_axes(landmarks_of(model)); }

Eigen::Matrix3d own_axes(const Landmarks& landmarks) {
  const Vec3 first = snapped(first_axis(landmarks));
  if (!(first.norm() > 0.5)) return Eigen::Matrix3d::Identity();
  // To snap one axis alone, beside a first that is oblique, tilts it against that one: by 1e-10, which put
  // the mesh of a part of 4 mm, 5 m from the origin, 5e-7 mm beside it. Where both can be snapped the last
  // step changes nothing.
  const Vec3 second = aside_of(snapped(aside_of(second_axis(landmarks, first), first)), first);
  Eigen::Matrix3d axes;
  axes << first.transpose(), second.transpose(), first.cross(second).transpose();
  return axes;
}

}  // namespace octet
