// SPDX-License-Identifier: BSD-3-Clause
// The sides of tetrahedra that lie on model faces: what surfaces and pressures are given on.
#pragma once

#include <array>
#include <optional>

#include "mesh/face_uses.h"
#include "mesh/mesh.h"

namespace octet {

/// A side of a tetrahedron, by the place (0 to 3) of the corner that it lacks.
struct TetSide {
  Mesh::Index tet = 0;
  std::size_t lacking = 0;
};

/// Faces of tetrahedra between vertices of the mesh's triangles: the only ones that can lie on model faces.
[[nodiscard]] FaceUses boundary_face_uses(const Mesh& mesh);

/// Looks up the sides that the mesh's triangles are.
class FaceSides {
 public:
  /// Keeps a reference to the mesh.
  explicit FaceSides(const Mesh& mesh);
  /// The side of the tetrahedron that the triangle's normal points out of, or of the only one there is; none
  /// for a triangle of no tetrahedron.
  [[nodiscard]] std::optional<TetSide> of(const std::array<Mesh::Index, 3>& triangle) const;

 private:
  const Mesh& mesh_;
  FaceUses uses_;
};

}  // namespace octet
