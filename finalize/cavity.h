// SPDX-License-Identifier: BSD-3-Clause
// The one door for changes of topology: a set of tetrahedra is replaced by another.
#pragma once

#include <span>

#include "finalize/work_mesh.h"

namespace octet {

struct NewTet {
  std::array<VertexId, 4> vertices;
  std::int32_t region = 0;
};

/// A mesh face to be classified on a model face, oriented as the model face.
struct NewTriangle {
  std::array<VertexId, 3> vertices;
  std::int32_t face = 0;
};

struct NewPiece {
  VertexId from, to;  ///< in the model edge's direction
  std::int32_t edge = 0;
};

/// Faces on the hull of the removed tetrahedra keep their classification. Faces listed in `triangles` take
/// theirs from there; all other new faces are inside a region.
struct CavityChange {
  std::span<const TetId> removed;
  std::span<const NewTet> added;
  std::span<const NewTriangle> triangles = {};
  std::span<const std::array<VertexId, 2>> removed_pieces = {};
  std::span<const NewPiece> added_pieces = {};
  VertexId removed_vertex = {};  ///< the one vertex that may lose all its tetrahedra
};

/// Makes the change and returns true; or finds that it would break an invariant of WorkMesh (a volume not
/// positive by the exact sign, a face with three sides, an outer face not classified, a lost vertex) and
/// returns false with the mesh untouched. `made` receives the new tetrahedra (cleared first).
[[nodiscard]] bool replace_cavity(WorkMesh& mesh, const CavityChange& change, std::vector<TetId>& made);

/// A vertex without tetrahedra, to be used by the next replace_cavity; `forget_vertex` takes the last one
/// back.
[[nodiscard]] VertexId add_vertex(WorkMesh& mesh, const Vec3& point, ModelRef on);
void forget_vertex(WorkMesh& mesh, VertexId v);

/// The shapes that the vertex's star would have with the vertex there.
[[nodiscard]] std::vector<double> shapes_at(const WorkMesh& mesh, VertexId v, const Vec3& place,
                                            std::span<const TetId> star);
/// Moves the vertex, of whose star the shapes will be these. False, and nothing moved, when a tetrahedron
/// would not be positive by the exact sign.
[[nodiscard]] bool move_vertex(WorkMesh& mesh, VertexId v, const Vec3& place, std::span<const TetId> star,
                               std::span<const double> shapes);

}  // namespace octet
