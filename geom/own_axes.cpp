// SPDX-License-Identifier: BSD-3-Clause
// Planes, then moments, then vertices; signs by the order of entities, which turns with the part, too.
#include "geom/own_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace octet {
namespace {

constexpr double kSame = 1e-6;        ///< areas and lengths that differ by less are equal
constexpr double kAngle = 1e-5;       ///< directions that differ by less are one; radians
constexpr double kOnAxis = 1e-9;      ///< the same for a direction and a coordinate axis
constexpr double kSameMoment = 1e-3;  ///< moments of no direction of their own

/// Second moments of the surface about its centroid, per area.
struct Moments {
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

Moments surface_moments(const Facets& facets) {
  Moments m;
  double area = 0.0;
  for (const bool centred : {false, true}) {
    if (centred) m.centre /= area;
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      const auto [a, b, c] = facet_corners(facets, t);
      const double weight = 0.5 * (b - a).cross(c - a).norm();
      if (!centred) {
        area += weight;
        m.centre += weight * (a + b + c) / 3.0;
        continue;
      }
      const Vec3 sum = a + b + c - 3.0 * m.centre;
      m.second += weight / 12.0 * sum * sum.transpose();
      for (const Vec3& corner : {a, b, c})
        m.second += weight / 12.0 * (corner - m.centre) * (corner - m.centre).transpose();
    }
  }
  m.second /= area;
  return m;
}

struct PlaneDirection {
  Vec3 normal;
  double area = 0.0;
};

/// In the order of the faces that come first; a part of countless directions is described by some of them.
std::vector<PlaneDirection> plane_directions(const Model& model) {
  constexpr std::size_t kMost = 256;
  std::vector<PlaneDirection> directions;
  std::vector<bool> seen(static_cast<std::size_t>(model.count(2)) + 1);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const int face = facets.face[t];
    if (seen[static_cast<std::size_t>(face)]) continue;
    seen[static_cast<std::size_t>(face)] = true;
    if (std::string_view(model.surface(face).kind()) != "plane") continue;
    const Vec3 normal = -model.face_normal(face, facets.uv[t][0]);  // mostly into the part: from low to high
    auto known = std::find_if(directions.begin(), directions.end(), [&](const PlaneDirection& d) {
      return d.normal.cross(normal).norm() < kAngle;
    });
    if (known == directions.end()) {
      if (directions.size() == kMost) continue;
      known = directions.insert(known, {normal});
    }
    known->area += std::abs(model.face(face).area);
  }
  return directions;
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
Vec3 farthest_vertex(const Model& model, const Vec3& centre, const Vec3& axis) {
  Vec3 farthest = Vec3::Zero();
  for (int v = 1; v <= model.count(0); ++v) {
    const Vec3 d = model.vertex(v).point - centre, across = d - d.dot(axis) * axis;
    if (across.norm() > (1.0 + kSame) * farthest.norm() + kSame * model.diagonal()) farthest = across;
  }
  return farthest;
}

/// Exactly along a coordinate axis where it is so within rounding.
Vec3 snapped(Vec3 axis) {
  for (double& x : axis)
    if (std::abs(x) < kOnAxis) x = 0.0;
  return axis.normalized();
}

/// A moment tells a line; the vertex tells its direction.
Vec3 towards(const Vec3& landmark, const Vec3& axis) { return landmark.dot(axis) < 0.0 ? Vec3(-axis) : axis; }

Vec3 first_axis(const Model& model, const std::vector<PlaneDirection>& directions, const Moments& moments) {
  if (const auto normal = main_direction(directions, Vec3::Zero())) return *normal;
  const auto axis = single_moment(moments.second, 3);
  return axis ? towards(farthest_vertex(model, moments.centre, Vec3::Zero()), *axis) : Vec3(Vec3::Zero());
}

Vec3 second_axis(const Model& model, const std::vector<PlaneDirection>& directions, const Moments& moments,
                 const Vec3& first) {
  if (const auto normal = main_direction(directions, first)) return *normal;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - first * first.transpose();
  const Vec3 landmark = farthest_vertex(model, moments.centre, first);
  if (const auto axis = single_moment(across * moments.second * across, 2)) return towards(landmark, *axis);
  if (landmark.norm() > 0.0) return landmark.normalized();
  Eigen::Index least = 0;
  first.cwiseAbs().minCoeff(&least);
  return across * Vec3::Unit(least);
}

}  // namespace

Eigen::Matrix3d own_axes(const Model& model) {
  const Moments moments = surface_moments(model.facets());
  const std::vector<PlaneDirection> directions = plane_directions(model);
  const Vec3 first = snapped(first_axis(model, directions, moments));
  if (!(first.norm() > 0.5)) return Eigen::Matrix3d::Identity();
  const Vec3 rough = second_axis(model, directions, moments, first);
  const Vec3 second = snapped((rough - rough.dot(first) * first).normalized());
  Eigen::Matrix3d axes;
  axes << first.transpose(), second.transpose(), snapped(first.cross(second)).transpose();
  return axes;
}

}  // namespace octet
