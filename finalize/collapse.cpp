// SPDX-License-Identifier: BSD-3-Clause
// Edge collapse: a vertex is drawn onto a neighbour, and what lay between them vanishes.
#include "finalize/collapse.h"

#include <algorithm>
#include <cstdlib>

#include "base/sort_unique.h"
#include "finalize/mean_shape.h"
#include "finalize/replace.h"
#include "finalize/shape.h"
#include "mesh/quality.h"

namespace octet {
namespace {

using Vertices = std::vector<VertexId>;

bool has(const Vertices& sorted, VertexId v) { return std::binary_search(sorted.begin(), sorted.end(), v); }

/// The neighbours of a vertex: all, and those along edges on model faces.
struct Neighbourhood {
  Vertices all, on_faces;
};

Neighbourhood neighbourhood(const WorkMesh& mesh, VertexId v, const std::vector<TetId>& tets) {
  Neighbourhood result;
  for (const TetId t : tets) {
    for (int i = 0; i < 4; ++i) {
      const VertexId w = mesh.tets[t][i];
      if (w == v) continue;
      result.all.push_back(w);
      for (int f = 0; f < 4; ++f) {
        if (f != i && mesh.tets[t][f] != v && mesh.face_on[t][f] != 0) {
          result.on_faces.push_back(w);
          break;
        }
      }
    }
  }
  sort_unique(result.all);
  sort_unique(result.on_faces);
  return result;
}

/// What the model says of drawing ring.a onto ring.b.
bool model_allows(const Workshop& shop, const EdgeRing& ring) {
  const WorkMesh& mesh = shop.mesh;
  const ModelRef on = mesh.on[ring.a];
  if (on.dim == 0) return false;
  if (on.dim == 3) return true;
  if (on.dim == 1) {
    if (std::abs(piece_on(mesh, ring.a, ring.b)) != on.tag) return false;
    const ModelEdge& edge = shop.model.edge(on.tag);
    const bool loop = edge.vertex[0] == edge.vertex[1];
    return mesh.pieces_on_edge[static_cast<std::size_t>(on.tag)] > (loop ? 3 : 1);
  }
  const auto walls = std::count_if(ring.face_on.begin(), ring.face_on.end(), [](int f) { return f != 0; });
  return walls == 2 && std::all_of(ring.face_on.begin(), ring.face_on.end(),
                                   [&](int f) { return f == 0 || std::abs(f) == on.tag; });
}

/// The link condition. `ring` goes around the edge, `a` and `b` are the ends' neighbourhoods, `tets` the star
/// of ring.a.
bool link_allows(const WorkMesh& mesh, const EdgeRing& ring, const Neighbourhood& a, const Neighbourhood& b,
                 const std::vector<TetId>& tets) {
  Vertices rim = ring.rim;
  sort_unique(rim);
  for (const VertexId v : a.all) {
    if (has(b.all, v) && !has(rim, v)) return false;
  }
  for (std::size_t i = 0; i < ring.rim.size(); ++i) {
    const VertexId v = ring.rim[i];
    if (has(a.on_faces, v) && has(b.on_faces, v) && ring.face_on[i] == 0) return false;
    if (piece_on(mesh, ring.a, v) != 0 && piece_on(mesh, ring.b, v) != 0) return false;
  }
  // A triangle of ring.a on two rim vertices must belong to a tetrahedron of the edge.
  for (const TetId t : tets) {
    if (corner_of(mesh, t, ring.b) >= 0) continue;
    for (int f = 0; f < 4; ++f) {
      if (mesh.tets[t][f] == ring.a) continue;
      int on_rim = 0;
      for (int c = 0; c < 3; ++c) on_rim += has(rim, mesh.tets[t][kTetFace[f][c]]);
      const TetId n = mesh.neighbours[t][f];
      if (on_rim == 2 && (!n.valid() || corner_of(mesh, n, ring.b) < 0)) return false;
    }
  }
  // A tetrahedron of the edge between two classified faces would press them together.
  return std::all_of(ring.tets.begin(), ring.tets.end(), [&](TetId t) {
    return mesh.face_on[t][corner_of(mesh, t, ring.a)] == 0 ||
           mesh.face_on[t][corner_of(mesh, t, ring.b)] == 0;
  });
}

struct Draft {
  std::vector<NewTet> tets;
  std::vector<NewTriangle> triangles;
  std::vector<MeasureChange> changes;
  Fit before, after;
};

/// The tetrahedron with `kept` in the place of `gone`.
NewTet drawn(const WorkMesh& mesh, TetId t, VertexId gone, VertexId kept) {
  NewTet tet{mesh.tets[t], mesh.region[t]};
  tet.vertices[corner_of(mesh, t, gone)] = kept;
  return tet;
}

/// Whether all tetrahedra with `kept` in the place of `gone` would be better than `floor`; if so `tets` is
/// the star of `gone`. The walk ends at the first that refuses: most collapses that are tried end there.
bool shapes_allow(Workshop& shop, VertexId gone, VertexId kept, double floor, std::vector<TetId>& tets) {
  WorkMesh& mesh = shop.mesh;
  return star_while(mesh, gone, tets, [&](TetId t) {
    if (corner_of(mesh, t, kept) >= 0) return true;
    const auto v = drawn(mesh, t, gone, kept).vertices;
    ++shop.work;
    return shape(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) > floor;
  });
}

/// The triangles of `gone` on model faces, drawn to `kept`, and whether they keep to the exact faces.
bool draft_triangles(Workshop& shop, VertexId gone, VertexId kept, const std::vector<TetId>& tets,
                     Draft& draft) {
  const WorkMesh& mesh = shop.mesh;
  double longest = 0.0;
  bool curved = false;
  std::vector<StarTriangle> triangles;
  collect_triangles(mesh, gone, tets, triangles);
  const auto area = [&](VertexId v, const StarTriangle& t) {
    return triangle_area(mesh.points[v], mesh.points[t.rim[0]], mesh.points[t.rim[1]]);
  };
  for (const StarTriangle& triangle : triangles) {
    const auto [x, y] = triangle.rim;
    draft.before.add(shop.guard.fit(mesh, triangle.face, {gone, x, y}));
    add_change(draft.changes, model_face(triangle.face), -area(gone, triangle));
    for (const VertexId v : triangle.rim)
      longest = std::max(longest, (mesh.points[v] - mesh.points[gone]).norm());
    curved = curved || !shop.guard.planar(triangle.face);
    if (x == kept || y == kept) continue;
    draft.after.add(shop.guard.fit(mesh, triangle.face, {kept, x, y}));
    add_change(draft.changes, model_face(triangle.face), area(kept, triangle));
    draft.triangles.push_back({{kept, x, y}, triangle.face});
  }
  // Not the longest edge alone: collapse by collapse it would grow, and the distance allowed with it.
  const double size = curved ? std::min(longest, shop.options.size_at(mesh.points[gone])) : longest;
  if (!BoundaryGuard::within(draft.after,
                             shop.guard.bound(draft.before, size, shop.room_at(mesh.points[gone]))))
    return false;
  if (!curved) {
    draft.changes.clear();
    return true;
  }
  const auto volume = [&](const std::array<VertexId, 4>& v) {
    return signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  };
  for (const TetId t : tets) add_change(draft.changes, model_region(mesh.region[t]), -volume(mesh.tets[t]));
  for (const NewTet& tet : draft.tets)
    add_change(draft.changes, model_region(tet.region), volume(tet.vertices));
  return shop.guard.admits(draft.changes);
}

/// Whether the model edge turns by more than a right angle along a new piece of it.
bool cuts_a_bend(Workshop& shop, const NewPiece& piece) {
  constexpr double kQuarterCircle = 1.1107;  // arc over chord
  return arc_over_chord(shop.model, piece.edge, shop.guard.on_edge(shop.mesh, piece.from, piece.edge, false),
                        shop.guard.on_edge(shop.mesh, piece.to, piece.edge, true)) > kQuarterCircle;
}

/// Whether the sum of merits rises and no new edge is much longer than the size.
bool raises_mean(const Workshop& shop, VertexId kept, const std::vector<TetId>& tets, const Draft& draft) {
  constexpr double kLongEdge = 1.6;
  constexpr double kLeastMeritGain = 0.02;
  const WorkMesh& mesh = shop.mesh;
  const double longest = kLongEdge * shop.size_at(mesh.points[kept]);
  const auto of = [&](const std::array<VertexId, 4>& v) {
    return merit(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  };
  double gain = -kLeastMeritGain;
  for (const TetId t : tets) gain -= of(mesh.tets[t]);
  for (const NewTet& tet : draft.tets) {
    gain += of(tet.vertices);
    for (const VertexId v : tet.vertices) {
      if ((mesh.points[v] - mesh.points[kept]).squaredNorm() > longest * longest) return false;
    }
  }
  return gain > 0.0;
}

bool collapse(Workshop& shop, VertexId gone, VertexId kept, double floor, bool for_mean) {
  WorkMesh& mesh = shop.mesh;
  const bool alone = mesh.hold[kept] == Hold::kAlone;
  if (mesh.on[gone].dim == 0 || mesh.held(gone) || (mesh.frozen(kept) && !alone)) return false;
  if (mesh.held(kept) && !alone && mesh.on[gone].dim < 3) return false;
  if (mesh.on[gone].dim < mesh.on[kept].dim) return false;
  if (!shapes_allow(shop, gone, kept, floor, shop.tets)) return false;
  const std::vector<TetId>& tets = shop.tets;
  Draft draft;
  for (const TetId t : tets)
    if (corner_of(mesh, t, kept) < 0) draft.tets.push_back(drawn(mesh, t, gone, kept));
  if (for_mean && !raises_mean(shop, kept, tets, draft)) return false;
  const auto shared =
      std::find_if(tets.begin(), tets.end(), [&](TetId t) { return corner_of(mesh, t, kept) >= 0; });
  if (shared == tets.end()) return false;
  EdgeRing ring;
  edge_ring(mesh, *shared, gone, kept, ring);
  if (!model_allows(shop, ring)) return false;
  std::vector<TetId> kept_tets;
  star(mesh, kept, kept_tets);
  if (!link_allows(mesh, ring, neighbourhood(mesh, gone, tets), neighbourhood(mesh, kept, kept_tets), tets) ||
      !draft_triangles(shop, gone, kept, tets, draft)) {
    return false;
  }
  CavityChange change{tets, draft.tets, draft.triangles};
  change.removed_vertex = gone;
  std::vector<std::array<VertexId, 2>> removed_pieces;
  std::vector<NewPiece> added_pieces;
  if (mesh.on[gone].dim == 1) {
    double sag = 0.0;
    for (const VertexId v : neighbourhood(mesh, gone, tets).all) {
      const std::int32_t tag = piece_on(mesh, gone, v);
      if (tag == 0) continue;
      removed_pieces.push_back({gone, v});
      sag = std::max(sag, shop.guard.piece_sag(mesh, gone, v, tag));
      if (v == kept) continue;
      added_pieces.push_back(tag > 0 ? NewPiece{kept, v, tag} : NewPiece{v, kept, -tag});
      if (cuts_a_bend(shop, added_pieces.back())) return false;
    }
    const double bound = shop.guard.piece_bound(sag, shop.room_at(mesh.points[gone]));
    if (std::any_of(added_pieces.begin(), added_pieces.end(), [&](const NewPiece& piece) {
          return shop.guard.piece_sag(mesh, piece.from, piece.to, piece.edge) > bound;
        }))
      return false;
  }
  change.removed_pieces = removed_pieces;
  change.added_pieces = added_pieces;
  if (!replace(shop, change)) return false;
  shop.guard.take(draft.changes);
  ++shop.report.collapses;
  return true;
}

}  // namespace

bool collapse_edge(Workshop& shop, VertexId gone, VertexId kept, double floor) {
  return collapse(shop, gone, kept, floor, false);
}

bool collapse_edge_for_mean(Workshop& shop, VertexId gone, VertexId kept, double floor) {
  return collapse(shop, gone, kept, floor, true);
}

}  // namespace octet
