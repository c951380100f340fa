// SPDX-License-Identifier: BSD-3-Clause
// Edge split: a new vertex on an edge, at once moved to the place that is best for all around it.
#include "finalize/split.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "finalize/replace.h"
#include "finalize/smooth.h"
#include "mesh/quality.h"

namespace octet {
namespace {

/// The entity that the edge of the ring lies on; not valid where that cannot be told.
ModelRef edge_entity(const WorkMesh& mesh, const EdgeRing& ring) {
  if (const std::int32_t tag = piece_on(mesh, ring.a, ring.b); tag != 0) return model_edge(std::abs(tag));
  std::int32_t face = 0;
  for (const std::int32_t tag : ring.face_on) {
    if (tag == 0) continue;
    if (face != 0 && face != std::abs(tag)) return {};
    face = std::abs(tag);
  }
  return face != 0 ? model_face(face) : model_region(mesh.region[ring.tets[0]]);
}

/// The star that the new vertex would have, and the fit of the triangles it replaces.
LocalStar future_star(const Workshop& shop, const EdgeRing& ring, ModelRef on) {
  const WorkMesh& mesh = shop.mesh;
  LocalStar star;
  star.on = on;
  const std::size_t n = ring.rim.size();
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  star.bases.resize(2 * ring.tets.size());
  for (std::size_t i = 0; i < ring.tets.size(); ++i) {
    const Vec3 &c = mesh.points[ring.rim[i]], &d = mesh.points[ring.rim[(i + 1) % n]];
    star.bases.set(2 * i, b, d, c);
    star.bases.set(2 * i + 1, a, c, d);
  }
  star.bases.close();
  star.length = (b - a).norm();
  Fit before;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t tag = ring.face_on[i];
    if (tag == 0) continue;
    // As seen from tets[i], (b, a, rim[i]) points outwards; the last face of an open ring is seen from the
    // tetrahedron before it.
    const bool last = !ring.closed && i + 1 == n;
    const bool forward = (tag > 0) != last;
    const VertexId x = forward ? ring.b : ring.a, y = forward ? ring.a : ring.b;
    before.add(shop.guard.fit(mesh, std::abs(tag), {x, y, ring.rim[i]}));
    star.triangles.push_back({std::abs(tag), {ring.rim[i], x}});
    star.triangles.push_back({std::abs(tag), {y, ring.rim[i]}});
  }
  if (on.dim < 3) dress_triangles(shop, star, before, star.length, shop.room_at(0.5 * (a + b)));
  return star;
}

/// How the new vertex would stand if it were where an end of the edge is: seeds for the projections.
Stand seeds_of(const Workshop& shop, const EdgeRing& ring, const LocalStar& star, const Vec3& middle) {
  Stand from;
  if (star.on.dim == 1) {
    const EdgeFoot foot = shop.model.edge_closest(star.on.tag, middle);
    from.t = foot.t;
    from.point = foot.point;
  }
  for (const int face : star.faces) {
    if (!shop.guard.planar(face)) from.seats.emplace_back(face, shop.guard.seat(shop.mesh, ring.a, face));
  }
  return from;
}

std::vector<MeasureChange> measure_changes(const Workshop& shop, const EdgeRing& ring, const LocalStar& star,
                                           const Vec3& place) {
  std::vector<MeasureChange> changes;
  if (std::all_of(star.faces.begin(), star.faces.end(), [&](int f) { return shop.guard.planar(f); }))
    return changes;
  const WorkMesh& mesh = shop.mesh;
  for (std::size_t i = 0; i < ring.tets.size(); ++i) {
    const TetId t = ring.tets[i];
    double change = -signed_volume(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
    for (std::size_t k : {2 * i, 2 * i + 1}) {
      const auto base = star.bases[k];
      change += signed_volume(base[0], base[1], base[2], place);
    }
    add_change(changes, model_region(mesh.region[t]), change);
  }
  // Each triangle at the edge becomes two, of which each has one of the edge's ends.
  const Vec3& b = mesh.points[ring.b];
  for (const auto& [face, rim] : star.triangles) {
    const Vec3 &x = mesh.points[rim[0]], &y = mesh.points[rim[1]];
    double change = triangle_area(place, x, y);
    if (rim[0] == ring.a || rim[1] == ring.a) change -= triangle_area(b, x, y);
    add_change(changes, model_face(face), change);
  }
  return changes;
}

bool commit_split(Workshop& shop, const EdgeRing& ring, const LocalStar& star, const Stand& stand) {
  WorkMesh& mesh = shop.mesh;
  const std::vector<MeasureChange> changes = measure_changes(shop, ring, star, stand.point);
  if (!shop.guard.admits(changes)) return false;
  const VertexId m = add_vertex(mesh, stand.point, star.on);
  std::vector<NewTet> tets;
  const std::size_t n = ring.rim.size();
  for (std::size_t i = 0; i < ring.tets.size(); ++i) {
    const VertexId c = ring.rim[i], d = ring.rim[(i + 1) % n];
    tets.push_back({{m, ring.b, c, d}, mesh.region[ring.tets[i]]});
    tets.push_back({{ring.a, m, c, d}, mesh.region[ring.tets[i]]});
  }
  std::vector<NewTriangle> triangles;
  for (const StarTriangle& t : star.triangles) triangles.push_back({{m, t.rim[0], t.rim[1]}, t.face});
  CavityChange change{ring.tets, tets, triangles};
  std::vector<std::array<VertexId, 2>> removed_pieces;
  std::vector<NewPiece> added_pieces;
  if (const std::int32_t tag = piece_on(mesh, ring.a, ring.b); tag != 0) {
    const VertexId from = tag > 0 ? ring.a : ring.b, to = tag > 0 ? ring.b : ring.a;
    removed_pieces.push_back({from, to});
    added_pieces = {{from, m, std::abs(tag)}, {m, to, std::abs(tag)}};
  }
  change.removed_pieces = removed_pieces;
  change.added_pieces = added_pieces;
  if (!replace(shop, change)) {
    forget_vertex(mesh, m);
    return false;
  }
  shop.guard.take(changes);
  record_stand(shop, m, stand);
  ++shop.report.splits;
  return true;
}

}  // namespace

double most_of_split(const WorkMesh& mesh, const EdgeRing& ring) {
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  const std::size_t n = ring.rim.size();
  double most = 1.0;
  for (std::size_t i = 0; i < ring.tets.size(); ++i) {
    const Vec3& c = mesh.points[ring.rim[i]];
    const Vec3 side = mesh.points[ring.rim[(i + 1) % n]] - c;
    const Vec3 to_a = side.cross(a - c), to_b = side.cross(b - c);
    const double lengths = std::sqrt(to_a.squaredNorm() * to_b.squaredNorm());
    most = std::min(most, 0.5 * (lengths - to_a.dot(to_b)) / lengths);
  }
  return most;
}

bool split_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor, double goal) {
  if (shop.mesh.frozen(a) || shop.mesh.frozen(b)) return false;
  const Vec3 middle = 0.5 * (shop.mesh.points[a] + shop.mesh.points[b]);
  // Halves that would count as nicks: splitting them again and again gains angles in thin walls, not
  // elements.
  const double least = 2.0 * shop.options.short_edge * shop.size_at(middle);
  if ((shop.mesh.points[a] - shop.mesh.points[b]).norm() < least) return false;
  EdgeRing ring;
  edge_ring(shop.mesh, t, a, b, ring);
  const ModelRef on = edge_entity(shop.mesh, ring);
  if (!on.valid() || (on.dim < 3 && (shop.mesh.held(a) || shop.mesh.held(b)))) return false;
  if (on.dim == 1 && !is_whole(shop.mesh, ring)) return false;
  constexpr double kRounding = 1e-9;
  if (most_of_split(shop.mesh, ring) + kRounding <= floor) return false;
  LocalStar star = future_star(shop, ring, on);
  const Stand from = seeds_of(shop, ring, star, middle);
  Stand stand;
  double worst = probe(shop, star, from, middle, {0.0, std::numeric_limits<double>::infinity()}, stand);
  if (worst > 0.0) worst = raise_worst(shop, star, stand, worst, goal);
  shop.work += star.work;
  return worst > floor && commit_split(shop, ring, star, stand);
}

}  // namespace octet
