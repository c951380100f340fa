// SPDX-License-Identifier: BSD-3-Clause
// The state of a Delaunay triangulation under construction.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.h"

namespace octet {

/// Invariants, on top of TetMesh's: a ghost has kGhostVertex as its vertex 3, and its face 3 is a facet of
/// the convex hull, seen counter-clockwise from outside; `vertex_tet[v]` is a live tetrahedron at v; `mark`
/// of dead slots is 0. Cost: 36 bytes a tetrahedron and 36 a vertex.
struct Complex {
  TetMesh mesh;
  IdVector<VertexId, std::uint64_t> rank;
  IdVector<VertexId, TetId> vertex_tet;
  IdVector<TetId, std::uint32_t> mark;
  std::vector<TetId> free_slots;
  std::uint32_t epoch = 0;
  TetId last;  ///< the tetrahedron made last: where walks start by default

  [[nodiscard]] const Vec3& point(VertexId v) const { return mesh.points[v]; }
  [[nodiscard]] bool ghost(TetId t) const { return mesh.tets[t][3] == kGhostVertex; }

  VertexId add_vertex(const Vec3& position, std::uint64_t order) {
    mesh.points.push_back(position);
    vertex_tet.push_back(TetId());
    return rank.push_back(order);
  }

  /// A slot for a tetrahedron without neighbours.
  TetId add_tet(const std::array<VertexId, 4>& vertices) {
    if (free_slots.empty()) {
      mesh.tets.push_back(vertices);
      mark.push_back(0);
      return mesh.neighbours.push_back({});
    }
    const TetId t = free_slots.back();
    free_slots.pop_back();
    mesh.tets[t] = vertices;
    mesh.neighbours[t] = {};
    return t;
  }

  void remove_tet(TetId t) {
    mesh.tets[t][0] = VertexId();
    mark[t] = 0;
    free_slots.push_back(t);
  }

  /// Index of `n` among the neighbours of t; requires that it is one.
  [[nodiscard]] int face_towards(TetId t, TetId n) const {
    const auto& around = mesh.neighbours[t];
    return around[0] == n ? 0 : around[1] == n ? 1 : around[2] == n ? 2 : 3;
  }

  /// Index of v among the vertices of t; requires that it is one.
  [[nodiscard]] int index_of(TetId t, VertexId v) const {
    const auto& vertices = mesh.tets[t];
    return vertices[0] == v ? 0 : vertices[1] == v ? 1 : vertices[2] == v ? 2 : 3;
  }
};

}  // namespace octet
