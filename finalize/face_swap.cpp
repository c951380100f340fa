// SPDX-License-Identifier: BSD-3-Clause
// Face swap: two tetrahedra that share a face become three around the edge between their far vertices.
#include "finalize/face_swap.h"

#include "finalize/cavity.h"
#include "finalize/shape.h"

namespace octet {

bool swap_face(Workshop& shop, TetId t, int face, double floor) {
  const WorkMesh& mesh = shop.mesh;
  const TetId n = mesh.neighbours[t][face];
  if (!n.valid() || mesh.face_on[t][face] != 0) return false;
  int back = 0;
  while (mesh.neighbours[n][back] != t) ++back;
  const VertexId p = mesh.tets[t][face], q = mesh.tets[n][back];
  // Face (x, y, z) is seen counter-clockwise from q and p lies behind it, so (x, y, p, q) is positive.
  std::array<NewTet, 3> added;
  for (int i = 0; i < 3; ++i) {
    const VertexId x = mesh.tets[t][kTetFace[face][i]], y = mesh.tets[t][kTetFace[face][(i + 1) % 3]];
    added[i] = {{x, y, p, q}, mesh.region[t]};
    const auto& v = added[i].vertices;
    ++shop.work;
    if (shape(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) <= floor)
      return false;
  }
  const std::array<TetId, 2> removed{t, n};
  if (!replace_cavity(shop.mesh, {removed, added}, shop.made)) return false;
  ++shop.report.face_swaps;
  return true;
}

}  // namespace octet
