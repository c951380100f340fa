// SPDX-License-Identifier: BSD-3-Clause
// The unique Delaunay triangulation of ranked points, by incremental insertion.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace octet {

/// Bowyer-Watson insertion with exact signs, ghost tetrahedra, and ties broken by rank, so that the result
/// depends on the set of (point, rank) only: neither on the order of insertion nor on what else is in another
/// block. Numbers of tetrahedra do depend on the order; the same calls give the same numbers everywhere.
///
/// A ghost has kGhostVertex as its vertex 3; its face 3 is a facet of the convex hull. Queries are const and
/// may run in several threads at once. Cost: 36 bytes a tetrahedron, 36 a vertex; some 1.5 million tetrahedra
/// a second from random points, 0.5 million from a lattice, whose every sphere is a tie.
///
/// [Schroeder & Shephard 1990, "Point ordering", "Insuring octant compatibility"]; the bounding octahedron of
/// eq. 6 is replaced by its limit h -> infinity (docs/ARCHITECTURE.md).
class Triangulation {
 public:
  /// Requires at least four points that are not coplanar among those of the first insert_all().
  Triangulation();
  ~Triangulation();
  Triangulation(Triangulation&&) noexcept;
  Triangulation& operator=(Triangulation&&) noexcept;

  /// Inserts all points; vertex i of the mesh is point i of the first call, later calls append. Points are
  /// visited in a spatial order of its own choice. Of points at the same place one is joined, the others stay
  /// vertices without tetrahedra. Throws InputError when the first points all lie in one plane.
  /// `cancelled`, where given, is asked often, from the calling thread; true ends it with Cancelled, and what
  /// is there then is no triangulation.
  void insert_all(std::span<const Vec3> points, std::span<const std::uint64_t> ranks,
                  const std::function<bool()>& cancelled = {});

  /// Inserts one point. `near` is a tetrahedron to start the walk from (invalid: the last one made).
  /// Returns the vertex: an existing one when the coordinates are equal to it.
  /// `created` receives the tetrahedra made, ghosts included (cleared first).
  VertexId insert(const Vec3& point, std::uint64_t rank, TetId near, std::vector<TetId>& created);

  /// What insert() would remove, without doing it: the tetrahedra in conflict with the point, ghosts
  /// included, the one that holds it first. None when a vertex is at the point.
  void conflicts(const Vec3& point, std::uint64_t rank, TetId near, std::vector<TetId>& tets) const;

  /// A tetrahedron that holds the point in its closure (a ghost when the point is outside the hull).
  [[nodiscard]] TetId locate(const Vec3& point, TetId near) const;

  [[nodiscard]] const TetMesh& mesh() const;
  [[nodiscard]] std::uint64_t rank(VertexId v) const;
  /// Some live tetrahedron at the vertex.
  [[nodiscard]] TetId tet_at(VertexId v) const;
  /// All tetrahedra around the vertex, ghosts included, in a deterministic order.
  void star(VertexId v, std::vector<TetId>& tets) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Empty when adjacency, positivity and the (ranked) empty-sphere property across every face hold, else what
/// does not.
[[nodiscard]] std::string check_triangulation(const Triangulation& triangulation);

}  // namespace octet
