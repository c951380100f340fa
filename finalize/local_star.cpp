// SPDX-License-Identifier: BSD-3-Clause
// One vertex and all that its place decides: found in the mesh, or thought up before it is made.
#include "finalize/local_star.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "base/sort_unique.h"
#include "finalize/workshop.h"

namespace octet {
namespace {

/// A projection on a curved face, in evaluations of `shape`.
constexpr std::uint64_t kProjectionWork = 30;

const Seat* find_seat(const Stand& stand, int face) {
  for (const auto& [f, seat] : stand.seats) {
    if (f == face) return &seat;
  }
  return nullptr;
}

std::optional<FaceFoot> project(const Workshop& shop, LocalStar& star, int face, const Vec3& p,
                                const Seat* seed) {
  star.work += kProjectionWork;
  const FaceFoot foot =
      seed != nullptr ? shop.model.face_project(face, p, seed->uv) : shop.model.face_project(face, p);
  return foot.converged ? std::optional(foot) : std::nullopt;
}

/// Whether a vertex of the face would stand on its surface beyond its border: where that is curved there is
/// room between the border and the mesh edges along it.
bool beyond_border(const Workshop& shop, int face, const Stand& stand) {
  const Seat* seat = find_seat(stand, face);
  const Vec2 uv = seat != nullptr ? seat->uv : shop.model.face_project(face, stand.point, Vec2::Zero()).uv;
  return shop.model.face_side(face, uv) == TrimSide::kOut;
}

/// Triangles of the tetrahedron at the vertex; those with two sides are taken from one of them.
void collect_triangles(const WorkMesh& mesh, TetId t, VertexId v, std::vector<StarTriangle>& triangles) {
  const auto& on = mesh.face_on[t];
  if ((on[0] | on[1] | on[2] | on[3]) == 0) return;
  for (int f = 0; f < 4; ++f) {
    const std::int32_t tag = on[f];
    if (tag == 0 || mesh.tets[t][f] == v || (tag < 0 && mesh.neighbours[t][f].valid())) continue;
    int c = 0;
    while (mesh.tets[t][kTetFace[f][c]] != v) ++c;
    StarTriangle triangle{std::abs(tag),
                          {mesh.tets[t][kTetFace[f][(c + 1) % 3]], mesh.tets[t][kTetFace[f][(c + 2) % 3]]}};
    if (tag < 0) std::swap(triangle.rim[0], triangle.rim[1]);
    triangles.push_back(triangle);
  }
}

}  // namespace

void collect_triangles(const WorkMesh& mesh, VertexId v, std::span<const TetId> tets,
                       std::vector<StarTriangle>& triangles) {
  for (const TetId t : tets) collect_triangles(mesh, t, v, triangles);
}

void local_bases(const WorkMesh& mesh, VertexId v, std::span<const TetId> tets, LocalStar& star) {
  star.on = mesh.on[v];
  star.work = 0;
  star.bases.resize(tets.size());
  for (std::size_t i = 0; i < tets.size(); ++i) {
    const TetId t = tets[i];
    const auto& f = kTetFace[corner_of(mesh, t, v)];
    star.bases.set(i, mesh.point(t, f[0]), mesh.point(t, f[2]), mesh.point(t, f[1]));
  }
  star.bases.close();
  star.length = star.bases.mean_length(mesh.points[v]);
}

/// A piece is in at least one triangle with either end.
void local_pieces(const Workshop& shop, VertexId v, double room, LocalStar& star) {
  std::array<VertexId, 2> ends;
  double sag = 0.0;
  for (const StarTriangle& triangle : star.triangles)
    for (const VertexId end : triangle.rim) {
      if (end == ends[0] || end == ends[1] || star.piece_ends.size() == ends.size()) continue;
      const std::int32_t tag = piece_on(shop.mesh, v, end);
      if (tag == 0) continue;
      ends[star.piece_ends.size()] = end;
      star.piece_ends.push_back(shop.guard.on_edge(shop.mesh, end, star.on.tag, tag > 0));
      sag = std::max(sag, shop.guard.piece_sag(shop.mesh, v, end, tag));
    }
  star.piece_bound = shop.guard.piece_bound(sag, room);
}

void leave_out_triangles(LocalStar& star) {
  star.triangles.clear();
  star.faces.clear();
  star.piece_ends.clear();
}

void local_triangles(const Workshop& shop, VertexId v, std::span<const TetId> tets, LocalStar& star) {
  leave_out_triangles(star);
  if (star.on.dim == 3) return;
  collect_triangles(shop.mesh, v, tets, star.triangles);
  Fit before;
  for (const StarTriangle& triangle : star.triangles) {
    if (shop.guard.planar(triangle.face)) continue;
    before.add(shop.guard.fit(shop.mesh, triangle.face, {v, triangle.rim[0], triangle.rim[1]}));
  }
  const double room = shop.room_at(shop.mesh.points[v]);
  dress_triangles(shop, star, before, star.length, room);
  if (star.on.dim == 1) local_pieces(shop, v, room, star);
}

void local_star(const Workshop& shop, VertexId v, std::span<const TetId> tets, LocalStar& star) {
  local_bases(shop.mesh, v, tets, star);
  local_triangles(shop, v, tets, star);
}

void dress_triangles(const Workshop& shop, LocalStar& star, const Fit& before, double size, double room) {
  star.bound = shop.guard.bound(before, size, room);
  star.piece_ends.clear();
  star.rims.clear();
  star.normals.clear();
  star.faces.clear();
  for (const StarTriangle& triangle : star.triangles) {
    const auto [x, y] = triangle.rim;
    const Vec3 nx = shop.guard.seat(shop.mesh, x, triangle.face).normal;
    const Vec3 ny = shop.guard.seat(shop.mesh, y, triangle.face).normal;
    star.rims.push_back({shop.mesh.points[x], shop.mesh.points[y]});
    star.normals.push_back({nx, ny});
    star.faces.push_back(triangle.face);
  }
  sort_unique(star.faces);
}

Stand current_stand(const Workshop& shop, VertexId v, const LocalStar& star) {
  Stand stand;
  stand.point = shop.mesh.points[v];
  if (star.on.dim == 1) stand.t = shop.guard.parameter(v);
  if (star.on.dim == 3) return stand;
  for (const int face : star.faces) {
    if (!shop.guard.planar(face)) stand.seats.emplace_back(face, shop.guard.seat(shop.mesh, v, face));
  }
  return stand;
}

bool take_stand(const Workshop& shop, LocalStar& star, const Stand& from, const Vec3& wish, Stand& stand) {
  stand.seats.clear();
  stand.point = wish;
  if (star.on.dim == 1) {
    // As far along the edge as the wish is along its tangent: any place on it will do, and the nearest one
    // takes ten times as long to find on a free curve.
    const Vec3 tangent = shop.model.edge_derivative(star.on.tag, from.t);
    const ModelEdge& edge = shop.model.edge(star.on.tag);
    const double squared = tangent.squaredNorm();
    if (squared == 0.0) return false;
    stand.t = std::clamp(from.t + (wish - from.point).dot(tangent) / squared, edge.t0, edge.t1);
    stand.point = shop.model.edge_point(star.on.tag, stand.t);
  } else if (star.on.dim == 2 && shop.guard.planar(star.on.tag)) {
    // Any foot is exact on a plane; its (u,v) is not kept.
    stand.point = shop.model.face_project(star.on.tag, wish, Vec2::Zero()).point;
  } else if (star.on.dim == 2) {
    const std::optional<FaceFoot> foot = project(shop, star, star.on.tag, wish, find_seat(from, star.on.tag));
    if (!foot) return false;
    stand.point = foot->point;
    stand.seats.emplace_back(star.on.tag, Seat{foot->uv, foot->normal});
  }
  return true;
}

bool take_seats(const Workshop& shop, LocalStar& star, const Stand& from, Stand& stand) {
  if (star.on.dim != 1) return true;
  for (const int face : star.faces) {
    if (shop.guard.planar(face)) continue;
    const std::optional<FaceFoot> foot = project(shop, star, face, stand.point, find_seat(from, face));
    if (!foot) return false;
    stand.seats.emplace_back(face, Seat{foot->uv, foot->normal});
  }
  return true;
}

StarMeasure measure(LocalStar& star, const Vec3& place, double floor) {
  star.work += star.bases.size();
  return star.bases.measure(place, floor);
}

bool triangles_fit(const Workshop& shop, const LocalStar& star, const Stand& stand) {
  if (star.on.dim == 2 && beyond_border(shop, star.on.tag, stand)) return false;
  for (const OnEdge& end : star.piece_ends)
    if (shop.guard.piece_sag(star.on.tag, {stand.point, stand.t}, end) > star.piece_bound ||
        turns_back(shop.model, star.on.tag, {stand.point, stand.t}, end))
      return false;
  for (std::size_t i = 0; i < star.triangles.size(); ++i) {
    const int face = star.triangles[i].face;
    // On a plane they neither turn nor leave it while their tetrahedra are positive.
    if (shop.guard.planar(face)) continue;
    const Seat* seat = find_seat(stand, face);
    const Vec3& normal = seat != nullptr ? seat->normal : star.normals[i][0];
    const Fit fit = BoundaryGuard::fit({stand.point, star.rims[i][0], star.rims[i][1]},
                                       {normal, star.normals[i][0], star.normals[i][1]});
    if (!BoundaryGuard::within(fit, star.bound)) return false;
  }
  return true;
}

void record_stand(Workshop& shop, VertexId v, const Stand& stand) {
  if (shop.mesh.on[v].dim == 1) shop.guard.set_parameter(v, stand.t);
  for (const auto& [face, seat] : stand.seats) shop.guard.set_seat(shop.mesh, v, face, seat);
}

}  // namespace octet
