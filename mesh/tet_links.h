// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra of a mesh share a face, and which faces are walls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// No tetrahedron.
inline constexpr Mesh::Index kNoTet = 0xffffffffu;

/// Per tetrahedron: its neighbours by face (kTetFace of mesh/tet_mesh.h; kNoTet on the outer boundary), and
/// whether the face is a triangle of the mesh, which lies on a model face.
struct TetLinks {
  std::vector<std::array<Mesh::Index, 4>> neighbour;
  std::vector<std::array<bool, 4>> wall;
};

/// Requires a conforming mesh (invariant 3 of mesh/mesh.h). O(tetrahedra).
[[nodiscard]] TetLinks tet_links(const Mesh& mesh);

}  // namespace octet
