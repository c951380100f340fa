// SPDX-License-Identifier: BSD-3-Clause
// The mesh that can be edited: tetrahedra with neighbours and classification.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/ids.h"
#include "base/model_ref.h"
#include "base/vec.h"
#include "finalize/journal.h"
#include "mesh/mesh.h"
#include "mesh/tet_mesh.h"

namespace octet {

/// What may not be done with a vertex.
enum class Hold : char {
  kFree,
  /// It stays where it is, and so does the boundary around it.
  kOnBoundary,
  /// Nothing that needs its star: its tetrahedra do not hang together by faces (parts that touch at a vertex
  /// or an edge), or others that are not given hold on to it.
  kFrozen,
  /// It is frozen, but nothing that is not given joins it and what goes into it by a collapse.
  kAlone,
};

/// Structure of arrays; local numbering as drawn in mesh/tet_mesh.h.
///
/// Invariants (`check_work_mesh` tests them word by word):
///  1. live tetrahedra are positive by the exact sign; dead slots have tets[t][0] invalid and wait in
///  `free_tets`.
///  2. `neighbours[t][i]` is the tetrahedron across face i, and points back; invalid on the outer boundary.
///  3. `face_on[t][i]` is 0 for faces inside a region, else the model face's tag, positive when the face's
///     outward normal is the model face's normal, negative when it is opposite. The two sides have opposite
///     signs. Faces without a neighbour, or between regions, are never 0, but for those of three frozen
///     vertices on the seam to tetrahedra that are not given; these faces stay.
///  4. `tet_of[v]` is a live tetrahedron at v; invalid for removed vertices.
///  5. `pieces` holds the mesh edges on model edges; both ends are live and on the edge's closure.
///  6. `quality[t]` is the shape (finalize/shape.h) of t, but for rounding.
struct WorkMesh {
  IdVector<VertexId, Vec3> points;
  IdVector<VertexId, ModelRef> on;
  IdVector<VertexId, TetId> tet_of;
  IdVector<VertexId, Hold> hold;

  IdVector<TetId, std::array<VertexId, 4>> tets;
  IdVector<TetId, std::array<TetId, 4>> neighbours;
  IdVector<TetId, std::array<std::int32_t, 4>> face_on;
  IdVector<TetId, std::int32_t> region;
  IdVector<TetId, double> quality;
  std::vector<TetId> free_tets;

  /// By `piece_key`; the value is the edge's tag, positive when the edge runs from the smaller vertex id to
  /// the larger. Looked up only, never iterated where the order could show.
  std::unordered_map<std::uint64_t, std::int32_t> pieces;
  std::vector<std::int32_t> pieces_on_edge;  ///< number of pieces, per model edge tag

  [[nodiscard]] bool alive(TetId t) const { return tets[t][0].valid(); }
  [[nodiscard]] bool alive(VertexId v) const { return tet_of[v].valid(); }
  [[nodiscard]] const Vec3& point(TetId t, int corner) const { return points[tets[t][corner]]; }
  [[nodiscard]] bool held(VertexId v) const { return hold[v] != Hold::kFree; }  ///< or frozen
  [[nodiscard]] bool frozen(VertexId v) const { return hold[v] >= Hold::kFrozen; }
  [[nodiscard]] bool on_boundary(VertexId v) const { return on[v].dim < 3; }

  // Scratch for walks: what carries the current epoch has been seen.
  IdVector<TetId, std::uint32_t> tet_mark;
  IdVector<VertexId, std::uint32_t> vertex_mark;
  std::uint32_t epoch = 0;

  Journal journal;
};

/// To be called before the slot is changed: keeps what it holds while the journal is open.
inline void keep_in_journal(WorkMesh& mesh, TetId t) {
  if (!mesh.journal.open) return;
  mesh.journal.tets.push_back(
      {t, mesh.tets[t], mesh.neighbours[t], mesh.face_on[t], mesh.region[t], mesh.quality[t]});
}
inline void keep_in_journal(WorkMesh& mesh, VertexId v) {
  if (mesh.journal.open) mesh.journal.vertices.push_back({v, mesh.points[v], mesh.tet_of[v]});
}
/// Opens the journal; requires it closed.
void open_journal(WorkMesh& mesh);
/// Closes it; what was done stays.
void close_journal(WorkMesh& mesh);
/// Closes it; the mesh is as it was when it was opened, but for marks of walks.
void take_back(WorkMesh& mesh);

/// The least quality among `tets`; 1 of none.
[[nodiscard]] double worst_quality(const WorkMesh& mesh, const std::vector<TetId>& tets);

[[nodiscard]] inline std::uint64_t piece_key(VertexId a, VertexId b) {
  const std::uint64_t lo = a < b ? a.index() : b.index(), hi = a < b ? b.index() : a.index();
  return (hi << 32) | lo;
}

/// The smaller vertex first.
[[nodiscard]] inline std::array<VertexId, 2> piece_ends(std::uint64_t key) {
  return {VertexId(static_cast<std::size_t>(key & 0xffffffffu)),
          VertexId(static_cast<std::size_t>(key >> 32))};
}

/// Signed tag of the piece as seen from a to b (positive when the model edge runs so), 0 when there is none.
[[nodiscard]] std::int32_t piece_on(const WorkMesh& mesh, VertexId a, VertexId b);
void add_piece(WorkMesh& mesh, VertexId a, VertexId b, std::int32_t signed_tag);
void remove_piece(WorkMesh& mesh, VertexId a, VertexId b);

/// Requires the invariants of Mesh, but for faces of three fixed vertices that have one tetrahedron and are
/// no triangles. The first `fixed` vertices are frozen. Vertex and tetrahedron numbers are kept. O(n log n).
[[nodiscard]] WorkMesh to_work_mesh(const Mesh& mesh, std::size_t fixed = 0);
/// Makes those of these vertices Hold::kAlone whose tetrahedra hang together by faces.
void release_alone(WorkMesh& mesh, const std::vector<Mesh::Index>& alone);
/// Live vertices and tetrahedra in the order of their numbers, edges and triangles sorted by (tag, vertices).
[[nodiscard]] Mesh to_mesh(const WorkMesh& work);

/// Local number of the vertex in the tetrahedron, -1 when it is not there.
[[nodiscard]] inline int corner_of(const WorkMesh& mesh, TetId t, VertexId v) {
  const auto& c = mesh.tets[t];
  return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : c[3] == v ? 3 : -1;
}

/// Sorts edges and triangles by (tag, vertices), the least vertex of a triangle first.
void sort_boundary(Mesh& mesh);

/// All tetrahedra at the vertex (cleared first), in the order of the walk from tet_of[v], for as long as
/// visit(t) returns true; whether it did to the end.
template <class Visit>
bool star_while(WorkMesh& mesh, VertexId v, std::vector<TetId>& tets, const Visit& visit) {
  tets.clear();
  const std::uint32_t epoch = ++mesh.epoch;
  tets.push_back(mesh.tet_of[v]);
  mesh.tet_mark[tets[0]] = epoch;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    const TetId t = tets[i];
    if (!visit(t)) return false;
    for (int f = 0; f < 4; ++f) {
      if (mesh.tets[t][f] == v) continue;
      const TetId n = mesh.neighbours[t][f];
      if (!n.valid() || mesh.tet_mark[n] == epoch) continue;
      mesh.tet_mark[n] = epoch;
      tets.push_back(n);
    }
  }
  return true;
}
/// All of them.
void star(WorkMesh& mesh, VertexId v, std::vector<TetId>& tets);

/// A tetrahedron that holds the edge, invalid when none does. Costs a star.
[[nodiscard]] TetId tet_with_edge(WorkMesh& mesh, VertexId a, VertexId b);

/// The tetrahedra around edge ab in counter-clockwise order seen from b:
/// tets[i] = (a, b, rim[i], rim[i+1]) positive.
///
///        rim[i+1] *       On a closed ring rim[i+1] wraps around and there are as many rim vertices as
///                /|       tetrahedra; on an open one (the edge lies on the outer boundary) one more.
///            a--b |       face_on[i] is the signed tag of face (a, b, rim[i]) as seen from tets[i]; for
///                \|       the last face of an open ring as seen from the last tetrahedron.
///           rim[i]*
struct EdgeRing {
  VertexId a, b;
  std::vector<TetId> tets;
  std::vector<VertexId> rim;
  std::vector<std::int32_t> face_on;
  bool closed = false;
};

/// Fills `ring` from a tetrahedron that holds both ends. False, and the ring not whole, where there are more
/// than `most` tetrahedra.
bool edge_ring(const WorkMesh& mesh, TetId t, VertexId a, VertexId b, EdgeRing& ring,
               std::size_t most = std::numeric_limits<std::size_t>::max());

/// Whether the ring has all tetrahedra of its edge. Not where a solid touches itself along a model edge:
/// there those of either side have a ring of their own. Costs a star.
[[nodiscard]] bool is_whole(WorkMesh& mesh, const EdgeRing& ring);

/// Empty when the invariants hold, else the first that does not. For tests.
[[nodiscard]] std::string check_work_mesh(const WorkMesh& mesh);

}  // namespace octet
