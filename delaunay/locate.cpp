// SPDX-License-Identifier: BSD-3-Clause
// The visibility walk.
#include "delaunay/locate.h"

#include "base/check.h"
#include "base/predicates.h"

namespace octet {

TetId walk_to(const Complex& complex, const Block& block, const Vec3& point, TetId start) {
  const TetMesh& mesh = complex.mesh;
  TetId t = start;
  OCTET_CHECK(t.valid());
  if (complex.ghost(t)) t = mesh.neighbours[t][3];

  TetId from;
  // The first face looked at changes from step to step: a fixed one makes walks drift to one side.
  for (unsigned step = 0;; ++step) {
    const auto& v = mesh.tets[t];
    TetId next;
    for (unsigned k = 0; k < 4 && !next.valid(); ++k) {
      const unsigned f = (step + k) & 3u;
      const TetId n = mesh.neighbours[t][f];
      if (n == from) continue;
      const auto& face = kTetFace[f];
      const int side =
          orient3d(complex.point(v[face[0]]), complex.point(v[face[1]]), complex.point(v[face[2]]), point);
      if (side > 0) next = n;
    }
    if (!next.valid()) return t;
    if (!block.holds(mesh.tets[next])) return {};
    if (complex.ghost(next)) return next;
    from = t;
    t = next;
  }
}

}  // namespace octet
