// SPDX-License-Identifier: BSD-3-Clause
// The one door for changes of topology: a set of tetrahedra is replaced by another.
#include "finalize/cavity.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "base/check.h"
#include "base/predicates.h"
#include "finalize/shape.h"
#include "mesh/sort_triple.h"

namespace octet {
namespace {

using Triple = std::array<VertexId, 3>;

/// One side of a face that the change touches.
struct Side {
  Triple key;
  bool odd = false;          ///< of the listing outward from the cavity or from the new tetrahedron
  bool added = false;        ///< side of a new tetrahedron, else of the hull
  std::uint32_t tet = 0;     ///< number in `added`, or the outer neighbour (TetId::kInvalid: outer boundary)
  std::int8_t face = 0;      ///< of that tetrahedron
  std::int32_t face_on = 0;  ///< hull: signed tag as seen from inside
};

void collect_hull(WorkMesh& mesh, std::span<const TetId> removed, std::vector<Side>& sides) {
  const std::uint32_t epoch = ++mesh.epoch;
  for (const TetId t : removed) mesh.tet_mark[t] = epoch;
  for (const TetId t : removed) {
    for (int f = 0; f < 4; ++f) {
      const TetId n = mesh.neighbours[t][f];
      if (n.valid() && mesh.tet_mark[n] == epoch) continue;
      Side side;
      for (int c = 0; c < 3; ++c) side.key[c] = mesh.tets[t][kTetFace[f][c]];
      side.odd = sort_triple(side.key);
      side.face_on = mesh.face_on[t][f];
      side.tet = n.index();
      if (n.valid()) {
        side.face = 0;
        while (mesh.neighbours[n][side.face] != t) ++side.face;
      }
      sides.push_back(side);
    }
  }
}

void collect_added(std::span<const NewTet> added, std::vector<Side>& sides) {
  for (std::uint32_t i = 0; i < added.size(); ++i) {
    for (std::int8_t f = 0; f < 4; ++f) {
      Side side;
      for (int c = 0; c < 3; ++c) side.key[c] = added[i].vertices[kTetFace[f][c]];
      side.odd = sort_triple(side.key);
      side.added = true;
      side.tet = i;
      side.face = f;
      sides.push_back(side);
    }
  }
}

/// Signed tag of the listed triangle for a side that lists its vertices with parity `odd`; 0 when not listed.
std::int32_t listed_tag(std::span<const NewTriangle> triangles, const Triple& key, bool odd) {
  for (const NewTriangle& triangle : triangles) {
    Triple sorted = triangle.vertices;
    const bool triangle_odd = sort_triple(sorted);
    if (sorted == key) return triangle_odd == odd ? triangle.face : -triangle.face;
  }
  return 0;
}

/// Two sides, or one, of each face.
struct Match {
  const Side* inner = nullptr;  ///< a new tetrahedron's side
  const Side* outer = nullptr;  ///< the hull's, or another new tetrahedron's
  std::int32_t tag = 0;         ///< signed, as seen from `inner`, else as seen from the cavity
};

/// Pairs the sides; false where the faces do not fit.
bool match_sides(const CavityChange& change, std::vector<Side>& sides, std::vector<Match>& matches) {
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.key, p.added, p.tet) < std::tie(q.key, q.added, q.tet);
  });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key == sides[i].key) ++end;
    const Side& first = sides[i];
    const Side* second = end - i == 2 ? &sides[i + 1] : nullptr;
    if (end - i > 2 || (second != nullptr && !second->added)) return false;
    Match match;
    if (second != nullptr) {
      match.inner = second;
      match.outer = &first;
      // A hull side lists its face as the removed tetrahedron did, so its replacement lists it alike.
      if ((second->odd == first.odd) == first.added) return false;
      match.tag = listed_tag(change.triangles, first.key, second->odd);
      if (match.tag == 0 && !first.added) match.tag = first.face_on;
    } else if (first.added) {
      match.inner = &first;
      match.tag = listed_tag(change.triangles, first.key, first.odd);
      if (match.tag == 0) return false;
    } else {
      match.outer = &first;
      match.tag = listed_tag(change.triangles, first.key, first.odd);
      if (match.tag == 0 && (first.tet != TetId::kInvalid || first.face_on == 0)) return false;
    }
    matches.push_back(match);
    i = end;
  }
  return true;
}

/// Whether faces without a tag separate nothing: same region on both sides, both sides there or, on the seam
/// to tetrahedra that are not given, as it was.
bool regions_agree(const WorkMesh& mesh, const CavityChange& change, const std::vector<Match>& matches) {
  for (const Match& match : matches) {
    if (match.inner == nullptr || match.tag != 0) continue;
    if (!match.outer->added && match.outer->tet == TetId::kInvalid) {
      if (match.outer->face_on != 0) return false;
      continue;
    }
    const std::int32_t other =
        match.outer->added ? change.added[match.outer->tet].region : mesh.region[TetId(match.outer->tet)];
    if (other != change.added[match.inner->tet].region) return false;
  }
  return true;
}

/// Whether each vertex of the removed tetrahedra, but the one given up, keeps a tetrahedron.
bool vertices_survive(WorkMesh& mesh, const CavityChange& change, const std::vector<Match>& matches) {
  const std::uint32_t epoch = ++mesh.epoch;
  for (const NewTet& tet : change.added) {
    for (const VertexId v : tet.vertices) mesh.vertex_mark[v] = epoch;
  }
  for (const Match& match : matches) {
    if (match.inner != nullptr || match.outer->tet == TetId::kInvalid) continue;
    for (const VertexId v : match.outer->key) mesh.vertex_mark[v] = epoch;
  }
  for (const TetId t : change.removed) {
    for (const VertexId v : mesh.tets[t]) {
      if (mesh.vertex_mark[v] != epoch && v != change.removed_vertex) return false;
    }
  }
  return true;
}

bool all_positive(const WorkMesh& mesh, std::span<const NewTet> added) {
  for (const NewTet& tet : added) {
    const auto& v = tet.vertices;
    if (orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) <= 0)
      return false;
  }
  return true;
}

TetId allocate_tet(WorkMesh& mesh) {
  if (!mesh.free_tets.empty()) {
    const TetId t = mesh.free_tets.back();
    mesh.free_tets.pop_back();
    if (mesh.journal.open) mesh.journal.free_tets.emplace_back(t, false);
    keep_in_journal(mesh, t);
    return t;
  }
  mesh.tets.push_back({});
  mesh.neighbours.push_back({});
  mesh.face_on.push_back({});
  mesh.region.push_back(0);
  mesh.quality.push_back(0.0);
  return mesh.tet_mark.push_back(0);
}

void make_tets(WorkMesh& mesh, const CavityChange& change, std::vector<TetId>& made) {
  for (auto t = change.removed.rbegin(); t != change.removed.rend(); ++t) {
    keep_in_journal(mesh, *t);
    mesh.tets[*t][0] = VertexId();
    mesh.free_tets.push_back(*t);
    if (mesh.journal.open) mesh.journal.free_tets.emplace_back(*t, true);
  }
  for (const NewTet& tet : change.added) {
    const TetId t = allocate_tet(mesh);
    mesh.tets[t] = tet.vertices;
    mesh.neighbours[t] = {};
    mesh.face_on[t] = {};
    mesh.region[t] = tet.region;
    mesh.quality[t] = shape(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
    made.push_back(t);
  }
}

void set_tet_of(WorkMesh& mesh, VertexId v, TetId t) {
  keep_in_journal(mesh, v);
  mesh.tet_of[v] = t;
}

void link_faces(WorkMesh& mesh, const std::vector<Match>& matches, const std::vector<TetId>& made) {
  for (const Match& match : matches) {
    TetId inner, outer;
    if (match.inner != nullptr) inner = made[match.inner->tet];
    if (match.outer != nullptr && match.outer->added) outer = made[match.outer->tet];
    if (match.outer != nullptr && !match.outer->added && match.outer->tet != TetId::kInvalid) {
      outer = TetId(match.outer->tet);
      keep_in_journal(mesh, outer);
    }
    if (inner.valid()) {
      mesh.neighbours[inner][match.inner->face] = outer;
      mesh.face_on[inner][match.inner->face] = match.tag;
    }
    if (outer.valid()) {
      mesh.neighbours[outer][match.outer->face] = inner;
      mesh.face_on[outer][match.outer->face] = -match.tag;
      for (const VertexId v : match.outer->key) set_tet_of(mesh, v, outer);
    }
  }
  for (const TetId t : made) {
    for (const VertexId v : mesh.tets[t]) set_tet_of(mesh, v, t);
  }
}

}  // namespace

bool replace_cavity(WorkMesh& mesh, const CavityChange& change, std::vector<TetId>& made) {
  made.clear();
  std::vector<Side> sides;
  std::vector<Match> matches;
  sides.reserve(4 * (change.removed.size() + change.added.size()));
  collect_hull(mesh, change.removed, sides);
  collect_added(change.added, sides);
  if (!match_sides(change, sides, matches) || !regions_agree(mesh, change, matches) ||
      !vertices_survive(mesh, change, matches) || !all_positive(mesh, change.added)) {
    return false;
  }
  if (change.removed_vertex.valid()) set_tet_of(mesh, change.removed_vertex, TetId());
  make_tets(mesh, change, made);
  link_faces(mesh, matches, made);
  for (const auto& [a, b] : change.removed_pieces) remove_piece(mesh, a, b);
  for (const NewPiece& piece : change.added_pieces) add_piece(mesh, piece.from, piece.to, piece.edge);
  return true;
}

VertexId add_vertex(WorkMesh& mesh, const Vec3& point, ModelRef on) {
  mesh.on.push_back(on);
  mesh.tet_of.push_back(TetId());
  mesh.hold.push_back(Hold::kFree);
  mesh.vertex_mark.push_back(0);
  return mesh.points.push_back(point);
}

void forget_vertex(WorkMesh& mesh, VertexId v) {
  OCTET_CHECK(v.index() + 1 == mesh.points.size() && !mesh.alive(v));
  mesh.points.values().pop_back();
  mesh.on.values().pop_back();
  mesh.tet_of.values().pop_back();
  mesh.hold.values().pop_back();
  mesh.vertex_mark.values().pop_back();
}

std::vector<double> shapes_at(const WorkMesh& mesh, VertexId v, const Vec3& place,
                              std::span<const TetId> star) {
  std::vector<double> shapes;
  shapes.reserve(star.size());
  for (const TetId t : star) {
    const auto point = [&](int corner) -> const Vec3& {
      return mesh.tets[t][corner] == v ? place : mesh.point(t, corner);
    };
    shapes.push_back(shape(point(0), point(1), point(2), point(3)));
  }
  return shapes;
}

bool move_vertex(WorkMesh& mesh, VertexId v, const Vec3& place, std::span<const TetId> star,
                 std::span<const double> shapes) {
  const Vec3 before = mesh.points[v];
  mesh.points[v] = place;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const TetId t = star[i];
    if (shapes[i] > kSurelyPositive) continue;
    if (orient3d(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3)) <= 0) {
      mesh.points[v] = before;
      return false;
    }
  }
  if (mesh.journal.open) mesh.journal.vertices.push_back({v, before, mesh.tet_of[v]});
  for (std::size_t i = 0; i < star.size(); ++i) {
    keep_in_journal(mesh, star[i]);
    mesh.quality[star[i]] = shapes[i];
  }
  return true;
}

}  // namespace octet
