// SPDX-License-Identifier: BSD-3-Clause
// The state of a Delaunay triangulation under construction.
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/rim_table.h"
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

  [[nodiscard]] const Vec3& point(VertexId v) const { return mesh.points[v]; }
  [[nodiscard]] bool ghost(TetId t) const { return mesh.tets[t][3] == kGhostVertex; }

  VertexId add_vertex(const Vec3& position, std::uint64_t order) {
    mesh.points.push_back(position);
    vertex_tet.push_back(TetId());
    return rank.push_back(order);
  }

  void reserve_vertices(std::size_t size) {
    mesh.points.reserve(size);
    rank.reserve(size);
    vertex_tet.reserve(size);
  }

  void reserve_slots(std::size_t size) {
    mesh.tets.reserve(size);
    mesh.neighbours.reserve(size);
    mark.reserve(size);
  }

  /// Appends dead slots up to that number.
  void add_slots(std::size_t size) {
    mesh.tets.resize(size);
    mesh.neighbours.resize(size);
    mark.resize(size);
  }

  /// Index of v among the vertices of t; requires that it is one.
  [[nodiscard]] int index_of(TetId t, VertexId v) const {
    const auto& vertices = mesh.tets[t];
    return vertices[0] == v ? 0 : vertices[1] == v ? 1 : vertices[2] == v ? 2 : 3;
  }
};

/// The vertices of one block. A tetrahedron is in the block when all its vertices are; ghosts are in none.
struct Block {
  const std::vector<std::uint32_t>* block_of = nullptr;  ///< per vertex; null: one block of everything
  std::uint32_t number = 0;

  [[nodiscard]] bool is_everything() const { return block_of == nullptr; }
  [[nodiscard]] bool holds(const std::array<VertexId, 4>& v) const {
    if (is_everything()) return true;
    const auto mine = [&](VertexId w) { return w != kGhostVertex && (*block_of)[w.index()] == number; };
    return mine(v[0]) && mine(v[1]) && mine(v[2]) && mine(v[3]);
  }
};

/// A face between a cavity and what is left.
struct CavityFace {
  TetId inner, outer;
  std::int8_t face;  ///< of `inner`
};

/// What one thread of insertion has to itself. Several work on one complex at once when their blocks have no
/// vertex in common: each reads and writes tetrahedra in its block, reads those that share a face with them,
/// and of these writes the one neighbour that is its own.
struct Inserter {
  Block block;
  std::vector<TetId> free_slots;  ///< dead slots of its own; the last is taken first
  std::uint32_t epoch = 0;        ///< marks are twice that, plus one in the cavity
  TetId last;                     ///< the tetrahedron made last: where walks start by default
  std::vector<TetId> cavity, created;
  std::vector<CavityFace> faces;  ///< all around the cavity, in its order
  RimTable rim;
};

}  // namespace octet
