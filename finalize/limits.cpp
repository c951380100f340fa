// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements.
#include "finalize/limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "finalize/shape.h"

namespace octet {
namespace {

/// Angle between the planes (a, b, c) and (a, b, d) at edge ab.
double angle_at_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 axis = (b - a).normalized();
  const Vec3 u = (c - a) - axis.dot(c - a) * axis, w = (d - a) - axis.dot(d - a) * axis;
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

/// Angle of the region's wedge at edge ab that holds t: the sum over the ring up to the walls on both sides.
double wedge_angle(const WorkMesh& mesh, TetId t, VertexId a, VertexId b) {
  EdgeRing ring;
  edge_ring(mesh, t, a, b, ring);
  const std::size_t n = ring.tets.size();
  const std::size_t at =
      static_cast<std::size_t>(std::find(ring.tets.begin(), ring.tets.end(), t) - ring.tets.begin());
  const auto angle = [&](std::size_t i) {
    return angle_at_edge(mesh.points[a], mesh.points[b], mesh.points[ring.rim[i]],
                         mesh.points[ring.rim[(i + 1) % ring.rim.size()]]);
  };
  double sum = angle(at);
  const auto wall = [&](std::size_t i) { return ring.face_on[i % ring.face_on.size()] != 0; };
  std::size_t steps = 1;
  for (std::size_t i = at + 1; steps < n && !wall(i) && (ring.closed || i < n); ++i, ++steps)
    sum += angle(i % n);
  for (std::size_t i = at + n; steps < n && !wall(i % n) && (ring.closed || i > n); --i, ++steps) {
    sum += angle((i - 1) % n);
  }
  return sum;
}

bool at_sharp_edge(Workshop& shop, TetId t) {
  const auto& v = shop.mesh.tets[t];
  for (const auto& e : kTetEdge) {
    const VertexId a = v[e[0]], b = v[e[1]];
    if (piece_on(shop.mesh, a, b) == 0) continue;
    if (wedge_angle(shop.mesh, t, a, b) < 2.0 * shop.options.target_dihedral) return true;
  }
  return false;
}

/// Whether all corners lie in the closure of one model face.
bool on_one_face(const Workshop& shop, TetId t) {
  const auto& v = shop.mesh.tets[t];
  for (int face = 1; face <= shop.model.count(2); ++face) {
    if (std::all_of(v.begin(), v.end(),
                    [&](VertexId x) { return shop.model.in_closure(shop.mesh.on[x], model_face(face)); })) {
      return true;
    }
  }
  return false;
}

bool in_thin_wall(Workshop& shop, TetId t) {
  const WorkMesh& mesh = shop.mesh;
  const auto& v = mesh.tets[t];
  if (!std::all_of(v.begin(), v.end(), [&](VertexId x) { return mesh.on_boundary(x); })) return false;
  double volume6 = 0.0, largest = 0.0;
  for (const auto& f : kTetFace) {
    const Vec3 normal =
        (mesh.point(t, f[1]) - mesh.point(t, f[0])).cross(mesh.point(t, f[2]) - mesh.point(t, f[0]));
    largest = std::max(largest, normal.norm());
  }
  volume6 = (mesh.point(t, 1) - mesh.point(t, 0))
                .cross(mesh.point(t, 2) - mesh.point(t, 0))
                .dot(mesh.point(t, 3) - mesh.point(t, 0));
  const double height = largest > 0.0 ? volume6 / largest : 0.0;
  return height < 0.5 * shop.size_at(mesh.points[v[0]]) && !on_one_face(shop, t);
}

}  // namespace

bool limited_by_geometry(Workshop& shop, TetId t) { return at_sharp_edge(shop, t) || in_thin_wall(shop, t); }

}  // namespace octet
