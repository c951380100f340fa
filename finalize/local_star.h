// SPDX-License-Identifier: BSD-3-Clause
// One vertex and all that its place decides: found in the mesh, or thought up before it is made.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "finalize/boundary_guard.h"
#include "finalize/star_bases.h"

namespace octet {

struct Workshop;

/// A triangle (vertex, x, y) on a model face, oriented as the face.
struct StarTriangle {
  int face = 0;
  std::array<VertexId, 2> rim;
};

/// Where a vertex stands: its point, and its parameters on the entity that holds it.
struct Stand {
  Vec3 point = Vec3::Zero();
  double t = 0.0;                           ///< on an edge
  std::vector<std::pair<int, Seat>> seats;  ///< per model face of the star's triangles, planar ones excepted
};

/// Many threads may work on stars of their own. Ensures nothing about the mesh: a star may stand for a vertex
/// that does not exist yet.
struct LocalStar {
  ModelRef on;                               ///< entity that the vertex must stay on
  StarBases bases;                           ///< of its tetrahedra
  std::vector<StarTriangle> triangles;       ///< on model faces
  std::vector<std::array<Vec3, 2>> rims;     ///< points of the triangles' other vertices
  std::vector<std::array<Vec3, 2>> normals;  ///< exact normals there
  std::vector<int> faces;                    ///< model faces of the triangles, once each
  Fit bound;                                 ///< what the triangles may become
  std::vector<OnEdge> piece_ends;            ///< of a vertex on an edge: the others of its pieces
  double piece_bound = 0.0;                  ///< how far the edge may be from them
  double length = 0.0;                       ///< mean distance from the place to the bases' corners
  std::uint64_t work = 0;                    ///< done on it, in evaluations of `shape`
};

/// Appends the triangles at the vertex on model faces, once each; `tets` are the tetrahedra around it.
void collect_triangles(const WorkMesh& mesh, VertexId v, std::span<const TetId> tets,
                       std::vector<StarTriangle>& triangles);

/// Makes `star` that of a vertex of the mesh; `tets` are the tetrahedra around it. What `star` was does not
/// matter: it is kept from vertex to vertex for its memory.
void local_star(const Workshop& shop, VertexId v, std::span<const TetId> tets, LocalStar& star);
/// Its two halves: what the tetrahedra are asked, then what the triangles are.
void local_bases(const WorkMesh& mesh, VertexId v, std::span<const TetId> tets, LocalStar& star);
void local_triangles(const Workshop& shop, VertexId v, std::span<const TetId> tets, LocalStar& star);
/// In place of the latter where all triangles lie in a plane, which they then neither turn in nor leave.
void leave_out_triangles(LocalStar& star);
/// Fills rims, normals, faces from `triangles`; `before` is the fit of the triangles to be replaced, `room`
/// that of the workshop there.
void dress_triangles(const Workshop& shop, LocalStar& star, const Fit& before, double size, double room);

/// How the vertex of the mesh stands now.
[[nodiscard]] Stand current_stand(const Workshop& shop, VertexId v, const LocalStar& star);

/// Brings `wish` onto the entity, starting from how the vertex stands; false when the projection fails. The
/// seats of a vertex on an edge are left for `take_seats`.
[[nodiscard]] bool take_stand(const Workshop& shop, LocalStar& star, const Stand& from, const Vec3& wish,
                              Stand& stand);
/// Seats a vertex on an edge on the faces there.
[[nodiscard]] bool take_seats(const Workshop& shop, LocalStar& star, const Stand& from, Stand& stand);

/// The star with the vertex there; may stop early at a worst shape not above `floor`.
[[nodiscard]] StarMeasure measure(LocalStar& star, const Vec3& place, double floor);
/// Whether the triangles keep to the bound with the vertex standing so, and a vertex on a face within its
/// border.
[[nodiscard]] bool triangles_fit(const Workshop& shop, const LocalStar& star, const Stand& stand);

/// Records how the vertex stands; the mesh's point is the caller's to move.
void record_stand(Workshop& shop, VertexId v, const Stand& stand);

}  // namespace octet
