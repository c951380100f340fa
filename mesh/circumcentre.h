// SPDX-License-Identifier: BSD-3-Clause
// The centre of the sphere through four points.
#pragma once

#include "base/vec.h"
#include "mesh/tet_mesh.h"

namespace octet {

/// Circumcentre of a finite tetrahedron in doubles; `reliable` is false for noise-flat ones, whose centre is
/// worthless.
struct Circumcentre {
  Vec3 point = Vec3::Zero();
  double squared_radius = 0.0;
  bool reliable = false;
};
[[nodiscard]] Circumcentre circumcentre(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
[[nodiscard]] inline Circumcentre circumcentre(const TetMesh& mesh, TetId t) {
  const auto& v = mesh.tets[t];
  return circumcentre(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
}

}  // namespace octet
