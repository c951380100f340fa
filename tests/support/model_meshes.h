// SPDX-License-Identifier: BSD-3-Clause
// Hand-made classified meshes of analytic models: boxes, a ball, a cylinder.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "geom/analytic.h"
#include "tests/support/box_mesh.h"

namespace octet::test {

/// What a model of boxes says about its points: whatever its numbering.
inline BoxPart part_of(const Model& model) {
  const auto on = [&model](const Vec3& p) {
    constexpr double kNear = 1e-9;
    for (int tag = 1; tag <= model.count(0); ++tag)
      if ((model.vertex(tag).point - p).norm() < kNear) return model_vertex(tag);
    for (int tag = 1; tag <= model.count(1); ++tag)
      if (model.edge(tag).use == EdgeUse::kReal && model.edge_closest(tag, p).distance < kNear)
        return model_edge(tag);
    for (int tag = 1; tag <= model.count(2); ++tag)
      if (model.face_closest(tag, p).distance < kNear) return model_face(tag);
    return model_region(model.region_at(p));
  };
  const auto direction = [&model](ModelRef ref, const Vec3& p) -> Vec3 {
    if (ref.dim == 1) return model.edge_derivative(ref.tag, model.edge_closest(ref.tag, p).t);
    return model.face_project(ref.tag, p).normal;
  };
  return {on, direction};
}

/// Tetrahedra positive, boundary triangles on `face_of` and oriented along the model, edges by `edge_of`.
inline void orient_tets(Mesh& mesh) {
  for (auto& t : mesh.tets) {
    const Vec3& a = mesh.points[t[0]];
    if ((mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).dot(mesh.points[t[3]] - a) < 0.0)
      std::swap(t[2], t[3]);
  }
}

/// A ball around the origin: an octahedron divided `levels` times and blown up, joined to the centre.
inline Mesh ball_mesh(const Model& model, double radius, int levels) {
  Mesh mesh;
  mesh.points = {{radius, 0, 0},  {-radius, 0, 0}, {0, radius, 0},
                 {0, -radius, 0}, {0, 0, radius},  {0, 0, -radius}};
  for (const Mesh::Index x : {0u, 1u})
    for (const Mesh::Index y : {2u, 3u})
      for (const Mesh::Index z : {4u, 5u}) mesh.triangles.push_back({x, y, z});
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Mesh::Index, Mesh::Index>, Mesh::Index> middle;
    const auto split = [&](Mesh::Index a, Mesh::Index b) {
      const auto [at, fresh] =
          middle.emplace(std::minmax(a, b), static_cast<Mesh::Index>(mesh.points.size()));
      if (fresh) mesh.points.push_back(radius * (mesh.points[a] + mesh.points[b]).normalized());
      return at->second;
    };
    std::vector<std::array<Mesh::Index, 3>> finer;
    for (const auto& t : mesh.triangles) {
      const Mesh::Index ab = split(t[0], t[1]), bc = split(t[1], t[2]), ca = split(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (auto& t : mesh.triangles) {
    const Vec3 normal = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    if (normal.dot(mesh.points[t[0]]) * (model.face(1).region[0] == 1 ? 1.0 : -1.0) < 0.0)
      std::swap(t[1], t[2]);
  }
  mesh.point_on.assign(mesh.points.size(), model_face(1));
  for (int tag = 1; tag <= model.count(0); ++tag)
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if ((mesh.points[v] - model.vertex(tag).point).norm() < 1e-9 * radius)
        mesh.point_on[v] = model_vertex(tag);
  mesh.triangle_on.assign(mesh.triangles.size(), 1);
  const auto centre = static_cast<Mesh::Index>(mesh.points.size());
  mesh.points.push_back(Vec3::Zero());
  mesh.point_on.push_back(model_region(1));
  for (const auto& t : mesh.triangles) mesh.tets.push_back({centre, t[0], t[1], t[2]});
  mesh.tet_in.assign(mesh.tets.size(), 1);
  orient_tets(mesh);
  return mesh;
}

/// A cylinder along z: rings of `around` points, the first at angle 0, in `along` layers, and an axis.
inline Mesh cylinder_mesh(const Model& model, double radius, double height, int around, int along) {
  Mesh mesh;
  const double turn = 2.0 * std::acos(-1.0) / around;
  const auto n = static_cast<Mesh::Index>(around + 1);
  for (int k = 0; k <= along; ++k) {
    const double z = k == along ? height : height * k / along;
    mesh.points.emplace_back(0.0, 0.0, z);
    for (int i = 0; i < around; ++i)
      mesh.points.emplace_back(radius * std::cos(turn * i), radius * std::sin(turn * i), z);
  }
  const BoxPart part = part_of(model);
  for (const Vec3& p : mesh.points) mesh.point_on.push_back(part.on(p));
  const auto layers = static_cast<Mesh::Index>(along);
  for (Mesh::Index k = 0; k < layers; ++k)
    for (Mesh::Index i = 0; i + 1 < n; ++i) {
      // A prism between two layers, cut by the order of its three columns so that neighbours fit.
      std::array<Mesh::Index, 3> low = {k * n, k * n + 1 + i, k * n + 1 + (i + 1) % (n - 1)};
      std::sort(low.begin(), low.end());
      const std::array<Mesh::Index, 3> high = {low[0] + n, low[1] + n, low[2] + n};
      mesh.tets.insert(mesh.tets.end(), {{low[0], low[1], low[2], high[2]},
                                         {low[0], low[1], high[1], high[2]},
                                         {low[0], high[0], high[1], high[2]}});
    }
  mesh.tet_in.assign(mesh.tets.size(), 1);
  orient_tets(mesh);
  // Chords and the triangles on the round face have their centroids beyond 0.86 of the radius, those of the
  // caps have theirs at two thirds.
  const auto round = [radius](const Vec3& p) -> Vec3 {
    const double r = std::hypot(p.x(), p.y());
    return r > 0.75 * radius ? Vec3(p.x() * radius / r, p.y() * radius / r, p.z()) : p;
  };
  const BoxPart rounded{[&](const Vec3& p) { return part.on(round(p)); },
                        [&](ModelRef ref, const Vec3& p) { return part.direction(ref, round(p)); }};
  box_mesh_detail::add_boundary(mesh, rounded);
  return mesh;
}

}  // namespace octet::test
