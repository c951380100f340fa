// SPDX-License-Identifier: BSD-3-Clause
// A growing tetrahedral complex with face adjacency: the store behind the Delaunay triangulation.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/ids.h"
#include "base/vec.h"

namespace octet {

/// Local numbering of a tetrahedron (v0,v1,v2,v3), drawn with v3 towards the reader:
///
///          v2            face i is opposite vertex i and is listed so that its normal points
///         /|\            outwards: kTetFace[i].
///        / | \           .
///      v0--v3--v1        .
///
inline constexpr int kTetFace[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
/// The six edges of a tetrahedron; edge e and edge 5 - e are opposite.
inline constexpr int kTetEdge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// The vertex at infinity: a tetrahedron that has it is a ghost, one per facet of the convex hull.
inline constexpr VertexId kGhostVertex = VertexId(VertexId::kInvalid - 1);

/// Tetrahedra as arrays, neighbours by face.
///
/// Invariants: `neighbour[t][i]` shares face i of t, and points back; vertices of finite tetrahedra are
/// positively oriented; dead slots have tet[t][0] invalid and are reused.
struct TetMesh {
  IdVector<VertexId, Vec3> points;
  IdVector<TetId, std::array<VertexId, 4>> tets;
  IdVector<TetId, std::array<TetId, 4>> neighbours;

  [[nodiscard]] bool alive(TetId t) const { return tets[t][0].valid(); }
  [[nodiscard]] bool ghost(TetId t) const {
    const auto& v = tets[t];
    return v[0] == kGhostVertex || v[1] == kGhostVertex || v[2] == kGhostVertex || v[3] == kGhostVertex;
  }
};

}  // namespace octet
