// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra of a mesh share a face, and which faces are walls.
#include "mesh/tet_links.h"

#include <algorithm>

#include "mesh/face_uses.h"

namespace octet {
namespace {

/// Local number of the face of `tet` that has these vertices.
std::size_t face_of(const std::array<Mesh::Index, 4>& tet, const std::array<Mesh::Index, 3>& face) {
  std::size_t i = 0;
  while (i < 3 && std::find(face.begin(), face.end(), tet[i]) != face.end()) ++i;
  return i;
}

}  // namespace

TetLinks tet_links(const Mesh& mesh) {
  TetLinks links;
  links.neighbour.assign(mesh.tets.size(), {kNoTet, kNoTet, kNoTet, kNoTet});
  links.wall.assign(mesh.tets.size(), {});
  const FaceUses uses(mesh);
  for (std::size_t i = 0; i + 1 < uses.all().size(); ++i) {
    const FaceUse &p = uses.all()[i], &q = uses.all()[i + 1];
    if (p.v != q.v) continue;
    links.neighbour[p.tet][face_of(mesh.tets[p.tet], p.v)] = q.tet;
    links.neighbour[q.tet][face_of(mesh.tets[q.tet], q.v)] = p.tet;
  }
  for (const auto& triangle : mesh.triangles) {
    for (const FaceUse& use : uses.find(triangle)) {
      links.wall[use.tet][face_of(mesh.tets[use.tet], use.v)] = true;
    }
  }
  return links;
}

}  // namespace octet
