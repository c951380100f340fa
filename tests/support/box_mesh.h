// SPDX-License-Identifier: BSD-3-Clause
// Hand-made classified meshes of boxes: a grid of cells, six tetrahedra in each.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet::test {

/// What a box mesh asks of the part: where a point lies, and how an edge or a face points there.
struct BoxPart {
  std::function<ModelRef(const Vec3&)> on;
  std::function<Vec3(ModelRef, const Vec3&)> direction;
};

/// The box [0,a]x[0,b]x[0,c] with numbers of its own: entities sorted by their place.
inline BoxPart plain_box(const Vec3& size) {
  const auto on = [size](const Vec3& p) {
    int code = 0, dim = 3;
    for (int i = 0; i < 3; ++i) {
      const int side = p[i] == 0.0 ? 0 : (p[i] == size[i] ? 2 : 1);
      code = 3 * code + side;
      if (side != 1) --dim;
    }
    int tag = 0;
    for (int other = 0; other <= code; ++other) {
      const int inside = (other % 3 == 1) + (other / 3 % 3 == 1) + (other / 9 == 1);
      if (inside == dim) ++tag;
    }
    return ModelRef{dim, tag};
  };
  const auto direction = [size](ModelRef ref, const Vec3& p) {
    Vec3 d = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      const bool inside = p[i] > 0.0 && p[i] < size[i];
      if (ref.dim == 1) d[i] = inside ? 1.0 : 0.0;
      if (ref.dim == 2) d[i] = inside ? 0.0 : (p[i] == 0.0 ? -1.0 : 1.0);
    }
    return d;
  };
  return {on, direction};
}

namespace box_mesh_detail {

/// Faces with one tetrahedron or between two regions become triangles; their sides between two model faces
/// become edges. The part is asked about the centroids.
inline void add_boundary(Mesh& mesh, const BoxPart& part) {
  constexpr int kFace[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::map<std::array<Mesh::Index, 3>, std::vector<std::int32_t>> regions;
  std::map<std::pair<Mesh::Index, Mesh::Index>, std::vector<std::int32_t>> faces;
  const auto at = [&mesh](Mesh::Index v) { return mesh.points[v]; };
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    for (const auto& f : kFace) {
      std::array<Mesh::Index, 3> v = {mesh.tets[i][f[0]], mesh.tets[i][f[1]], mesh.tets[i][f[2]]};
      std::sort(v.begin(), v.end());
      regions[v].push_back(mesh.tet_in[i]);
    }
  for (auto& [key, in] : regions) {
    if (in.size() == 2 && in[0] == in[1]) continue;
    auto v = key;
    const Vec3 centre = (at(v[0]) + at(v[1]) + at(v[2])) / 3.0;
    const ModelRef ref = part.on(centre);
    const Vec3 normal = (at(v[1]) - at(v[0])).cross(at(v[2]) - at(v[0]));
    if (normal.dot(part.direction(ref, centre)) < 0.0) std::swap(v[1], v[2]);
    mesh.triangles.push_back(v);
    mesh.triangle_on.push_back(ref.tag);
    for (int k = 0; k < 3; ++k) faces[std::minmax(v[k], v[(k + 1) % 3])].push_back(ref.tag);
  }
  for (auto& [key, on] : faces) {
    if (std::count(on.begin(), on.end(), on[0]) == static_cast<std::ptrdiff_t>(on.size())) continue;
    auto [a, b] = key;
    const Vec3 centre = 0.5 * (at(a) + at(b));
    const ModelRef ref = part.on(centre);
    if ((at(b) - at(a)).dot(part.direction(ref, centre)) < 0.0) std::swap(a, b);
    mesh.edges.push_back({a, b});
    mesh.edge_on.push_back(ref.tag);
  }
}

}  // namespace box_mesh_detail

/// The grid's cells are cut along their main diagonals (Kuhn), so that neighbours fit.
inline Mesh box_mesh(const BoxPart& part, const Vec3& size, const std::array<int, 3>& cells) {
  Mesh mesh;
  const auto index = [&cells](int i, int j, int k) {
    return static_cast<Mesh::Index>((k * (cells[1] + 1) + j) * (cells[0] + 1) + i);
  };
  const auto along = [&](int axis, int i) {
    return i == cells[axis] ? size[axis] : size[axis] * i / cells[axis];
  };
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) mesh.points.emplace_back(along(0, i), along(1, j), along(2, k));
  for (const Vec3& p : mesh.points) mesh.point_on.push_back(part.on(p));
  constexpr int kOrder[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (int o = 0; o < 6; ++o) {
          std::array<int, 3> c = {i, j, k};
          std::array<Mesh::Index, 4> tet = {index(c[0], c[1], c[2])};
          for (int s = 0; s < 3; ++s) {
            ++c[kOrder[o][s]];
            tet[s + 1] = index(c[0], c[1], c[2]);
          }
          if (o >= 3) std::swap(tet[2], tet[3]);
          Vec3 centre = Vec3::Zero();
          for (const Mesh::Index v : tet) centre += 0.25 * mesh.points[v];
          mesh.tets.push_back(tet);
          mesh.tet_in.push_back(part.on(centre).tag);
        }
  box_mesh_detail::add_boundary(mesh, part);
  return mesh;
}

inline Mesh plain_box_mesh(int cells) {
  const Vec3 size(3.0, 2.0, 1.0);
  return box_mesh(plain_box(size), size, {cells, cells, cells});
}

/// Two halves along x of the box [0,2]x[0,1]x[0,1], regions 1 and 2 with elements in turns; face 7 between
/// them points out of the region `behind`.
inline Mesh halved_box_mesh(int behind, const std::array<int, 3>& cells) {
  const Vec3 size(2.0, 1.0, 1.0);
  const BoxPart whole = plain_box(size);
  const BoxPart halves{[&](const Vec3& p) {
                         const ModelRef on = whole.on(p);
                         if (on.dim < 3) return on;
                         return p.x() == 1.0 ? model_face(7) : model_region(p.x() < 1.0 ? 1 : 2);
                       },
                       [&](ModelRef ref, const Vec3& p) {
                         return ref == model_face(7) ? Vec3(behind == 1 ? 1 : -1, 0, 0)
                                                     : whole.direction(ref, p);
                       }};
  return box_mesh(halves, size, cells);
}

/// The outline of plain_box, with bounding relations and two names.
inline ModelOutline plain_box_outline(const Vec3& size, bool named) {
  ModelOutline outline;
  const BoxPart part = plain_box(size);
  for (int code = 0; code < 27; ++code) {
    const std::array<int, 3> c = {code / 9, code / 3 % 3, code % 3};
    Vec3 p;
    Box3 box;
    for (int i = 0; i < 3; ++i) {
      p[i] = 0.5 * c[i] * size[i];
      box.lo[i] = c[i] == 2 ? size[i] : 0.0;
      box.hi[i] = c[i] == 0 ? 0.0 : size[i];
    }
    const ModelRef ref = part.on(p);
    OutlineEntity entity;
    entity.tag = ref.tag;
    entity.box = box;
    for (int i = 0; i < 3; ++i)
      if (c[i] == 1)
        for (const double end : {0.0, size[i]}) {
          Vec3 q = p;
          q[i] = end;
          const int tag = part.on(q).tag;
          entity.bounded_by.push_back(ref.dim == 1 && end > 0.0 ? -tag : tag);
        }
    if (named && ref.dim == 2 && ref.tag == 3) entity.name = "bore \"A\"";
    if (named && ref.dim == 3) entity.name = "body";
    outline.entities[ref.dim].push_back(entity);
  }
  return outline;
}

}  // namespace octet::test
