// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements.
#include "finalize/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "mesh/tet_mesh.h"

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

/// Whether two model edges leave a corner of t along edges of t at a small angle (a tangent arc and its
/// line).
bool at_sharp_corner(Workshop& shop, TetId t) {
  const WorkMesh& mesh = shop.mesh;
  const auto& v = mesh.tets[t];
  for (int i = 0; i < 4; ++i) {
    if (mesh.on[v[i]].dim != 0) continue;
    for (int j = 0; j < 4; ++j) {
      for (int k = j + 1; k < 4; ++k) {
        if (j == i || k == i || piece_on(mesh, v[i], v[j]) == 0 || piece_on(mesh, v[i], v[k]) == 0) continue;
        const Vec3 a = mesh.points[v[j]] - mesh.points[v[i]], b = mesh.points[v[k]] - mesh.points[v[i]];
        if (std::atan2(a.cross(b).norm(), a.dot(b)) < 2.0 * shop.options.target_dihedral) return true;
      }
    }
  }
  return false;
}

/// Whether the boundary is met again within `reach`, straight through the region from the middle of face
/// `face` of t, which lies on a model face.
bool wall_within(const Workshop& shop, TetId t, int face, double reach) {
  const auto& f = kTetFace[face];
  const WorkMesh& mesh = shop.mesh;
  const Vec3 middle = (mesh.point(t, f[0]) + mesh.point(t, f[1]) + mesh.point(t, f[2])) / 3.0;
  const std::int32_t tag = mesh.face_on[t][face];
  const FaceFoot foot = shop.model.face_project(std::abs(tag), middle);
  const Vec3 inward = tag > 0 ? Vec3(-foot.normal) : foot.normal;
  std::vector<Hit> hits;
  shop.model.intersect(foot.point + 1e-3 * reach * inward, foot.point + reach * inward, hits);
  return !hits.empty();
}

/// The tetrahedra that share a vertex with t.
std::vector<TetId> neighbourhood(Workshop& shop, TetId t) {
  std::vector<TetId> around, near;
  for (const VertexId corner : std::array(shop.mesh.tets[t])) {
    star(shop.mesh, corner, around);
    near.insert(near.end(), around.begin(), around.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

bool in_thin_wall(const Workshop& shop, const std::vector<TetId>& near, std::int32_t region, double size) {
  return std::any_of(near.begin(), near.end(), [&](TetId s) {
    for (int f = 0; f < 4; ++f) {
      if (shop.mesh.face_on[s][f] != 0 && shop.mesh.region[s] == region &&
          wall_within(shop, s, f, 0.5 * size)) {
        return true;
      }
    }
    return false;
  });
}

/// Whether two model edges or vertices come nearer to each other than what counts as a nick: no collapse may
/// join them.
bool at_small_feature(const Workshop& shop, const std::vector<TetId>& near, double size) {
  const WorkMesh& mesh = shop.mesh;
  const double least = shop.options.short_edge * size;
  return std::any_of(near.begin(), near.end(), [&](TetId s) {
    return std::any_of(std::begin(kTetEdge), std::end(kTetEdge), [&](const int(&e)[2]) {
      const VertexId a = mesh.tets[s][e[0]], b = mesh.tets[s][e[1]];
      const ModelRef p = mesh.on[a], q = mesh.on[b];
      if (p.dim > 1 || q.dim > 1 || p == q || (p.dim != q.dim && piece_on(mesh, a, b) != 0)) return false;
      return (mesh.points[a] - mesh.points[b]).norm() < least;
    });
  });
}

}  // namespace

bool limited_by_geometry(Workshop& shop, TetId t) {
  if (at_sharp_edge(shop, t) || at_sharp_corner(shop, t)) return true;
  const double size = shop.size_at(shop.mesh.point(t, 0));
  const std::vector<TetId> near = neighbourhood(shop, t);
  return at_small_feature(shop, near, size) || in_thin_wall(shop, near, shop.mesh.region[t], size);
}

}  // namespace octet
