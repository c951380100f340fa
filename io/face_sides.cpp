// SPDX-License-Identifier: BSD-3-Clause
// A look-up among the faces between vertices of the boundary.
#include "io/face_sides.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace octet {

FaceUses boundary_face_uses(const Mesh& mesh) {
  std::vector<std::uint8_t> on_boundary(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const Mesh::Index v : triangle) on_boundary[v] = 1;
  return {mesh, on_boundary};
}

FaceSides::FaceSides(const Mesh& mesh) : mesh_(mesh), uses_(boundary_face_uses(mesh)) {}

std::optional<TetSide> FaceSides::of(const std::array<Mesh::Index, 3>& triangle) const {
  const auto uses = uses_.find(triangle);
  if (uses.empty()) return std::nullopt;
  const bool even = sorted_face(triangle).even;
  const auto out = std::find_if(uses.begin(), uses.end(), [&](const FaceUse& u) { return u.even == even; });
  const FaceUse& use = out == uses.end() ? uses.front() : *out;
  const auto& tet = mesh_.tets[use.tet];
  const auto lacking = std::find_if(tet.begin(), tet.end(), [&](const Mesh::Index v) {
    return std::find(use.v.begin(), use.v.end(), v) == use.v.end();
  });
  return TetSide{use.tet, static_cast<std::size_t>(lacking - tet.begin())};
}

}  // namespace octet
