// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements.
#include "finalize/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Whether the boundary is met again within `reach`, straight from a vertex inside a model face through the
/// region.
bool wall_within(const Workshop& shop, VertexId v, std::int32_t region, double reach) {
  const int face = shop.mesh.on[v].tag;
  const FaceFoot foot = shop.model.face_project(face, shop.mesh.points[v]);
  const Vec3 inward = shop.model.face(face).region[0] == region ? Vec3(-foot.normal) : foot.normal;
  std::vector<Hit> hits;
  shop.model.intersect(foot.point + 1e-3 * reach * inward, foot.point + reach * inward, hits);
  return !hits.empty();
}

/// The vertices inside model faces around t: its own say nothing where they lie on model edges.
std::vector<VertexId> face_vertices_around(Workshop& shop, TetId t) {
  std::vector<VertexId> vertices;
  std::vector<TetId> around;
  for (const VertexId corner : std::array(shop.mesh.tets[t])) {
    star(shop.mesh, corner, around);
    for (const TetId s : around) {
      if (shop.mesh.region[s] != shop.mesh.region[t]) continue;
      for (const VertexId v : shop.mesh.tets[s]) {
        if (shop.mesh.on[v].dim == 2) vertices.push_back(v);
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

bool in_thin_wall(Workshop& shop, TetId t) {
  const double half = 0.5 * shop.size_at(shop.mesh.point(t, 0));
  const std::vector<VertexId> vertices = face_vertices_around(shop, t);
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return wall_within(shop, v, shop.mesh.region[t], half); });
}

}  // namespace

bool limited_by_geometry(Workshop& shop, TetId t) { return at_sharp_edge(shop, t) || in_thin_wall(shop, t); }

}  // namespace octet
