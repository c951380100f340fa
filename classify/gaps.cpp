// SPDX-License-Identifier: BSD-3-Clause
// Every claim that makes the facets a surface on the model, tested edge by edge and vertex by vertex.
#include "classify/gaps.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "base/blocks.h"
#include "classify/dual_crossings.h"
#include "mesh/circumcentre.h"

namespace octet {
namespace {

/// The side of a facet at one of its edges.
struct EdgeUseOfFacet {
  std::uint32_t a, b;  ///< a < b
  std::uint32_t facet;
};

bool same_edge(const EdgeUseOfFacet& x, const EdgeUseOfFacet& y) { return x.a == y.a && x.b == y.b; }

/// Sorted by a, b, facet; without the edges at vertices for which `is_done`.
template <class Done>
std::vector<EdgeUseOfFacet> edge_uses(const Done& is_done, const std::vector<BoundaryFacet>& facets) {
  auto uses = collect<EdgeUseOfFacet>(facets.size(), [&](std::size_t n, std::vector<EdgeUseOfFacet>& found) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = facets[n].v[i].index(), b = facets[n].v[(i + 1) % 3].index();
      if (!is_done(a) && !is_done(b))
        found.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(n)});
    }
  });
  tbb::parallel_sort(uses.begin(), uses.end(), [](const EdgeUseOfFacet& x, const EdgeUseOfFacet& y) {
    return std::tie(x.a, x.b, x.facet) < std::tie(y.a, y.b, y.facet);
  });
  return uses;
}

/// The facets at each vertex that is asked for, ascending; none at others.
class FacetsAtVertices {
 public:
  template <class Asked>
  FacetsAtVertices(std::size_t vertices, const std::vector<BoundaryFacet>& facets, const Asked& is_asked)
      : end_(vertices + 1, 0) {
    for (const BoundaryFacet& f : facets)
      for (const VertexId v : f.v) end_[v.index() + 1] += is_asked(v.index()) ? 1 : 0;
    std::partial_sum(end_.begin(), end_.end(), end_.begin());
    facets_.resize(end_.back());
    for (std::uint32_t n = 0; n < facets.size(); ++n)
      for (const VertexId v : facets[n].v)
        if (is_asked(v.index())) facets_[end_[v.index()]++] = n;
  }
  [[nodiscard]] std::span<const std::uint32_t> operator[](VertexId v) const {
    const std::uint32_t begin = v.index() == 0 ? 0 : end_[v.index() - 1];
    return std::span(facets_).subspan(begin, end_[v.index()] - begin);
  }

 private:
  std::vector<std::uint32_t> end_;  ///< per vertex: where its facets end, and those of the next begin
  std::vector<std::uint32_t> facets_;
};

}  // namespace

void GapMemory::add(const TetMesh& mesh, std::span<const TetId> created) {
  for (const TetId t : created) {
    if (!mesh.alive(t)) continue;
    for (const VertexId v : mesh.tets[t])
      if (v != kGhostVertex && v.index() < touched_.size()) touched_[v.index()] = 1;
  }
}

void GapMemory::ask_again(VertexId v) {
  if (v.index() < touched_.size()) touched_[v.index()] = 1;
  if (v.index() < fans_.size()) fans_[v.index()] = kAsk;
}

class GapFinder {
 public:
  GapFinder(Band& band, const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
            GapMemory& memory)
      : model_(band.model()), mesh_(mesh), on_(on), chains_(chains), band_(band), memory_(memory) {}

  std::vector<Gap> run(GapScope scope) {
    missing_pieces();
    if (!gaps_.empty() && scope == GapScope::kPiecesFirst) return std::move(gaps_);
    if (!memory_.expected_) memory_.expected_.emplace(model_);
    facets_ = &band_.facets(mesh_, on_);
    for (std::uint32_t n = 0; n < facets_->size(); ++n)
      if ((*facets_)[n].face == 0) add_facet(GapKind::kNoFace, n, ModelRef{});
    for (const VertexId v : band_.take_changed())
      if (v.index() < memory_.fans_.size()) memory_.fans_[v.index()] = GapMemory::kAsk;
    memory_.fans_.resize(on_.size(), GapMemory::kAsk);
    const FacetsAtVertices around(on_.size(), *facets_, [&](std::uint32_t v) { return is_asked(v); });
    const std::vector<BrokenFan> broken = broken_fans(around);
    edges();
    vertices(around, broken);
    bare_faces();
    return std::move(gaps_);
  }

 private:
  /// Number of the piece that joins two vertices, or UINT32_MAX.
  [[nodiscard]] std::uint32_t piece_at(VertexId a, VertexId b) const {
    return on_[a.index()].dim > 1 || on_[b.index()].dim > 1 ? UINT32_MAX : chains_.find(a, b);
  }

  [[nodiscard]] bool is_asked(std::uint32_t v) const { return memory_.fans_[v] == GapMemory::kAsk; }

  /// Only pieces between two vertices that tetrahedra came to may have come or gone.
  void missing_pieces() {
    std::vector<std::uint8_t>&touched = memory_.touched_, &present = memory_.present_;
    touched.resize(on_.size(), 1);
    for (std::size_t v = 0; v < on_.size(); ++v)
      if (on_[v].dim > 1) touched[v] = 0;
    present.resize(chains_.pieces().size(), 0);
    for (std::uint32_t n = 0; n < present.size(); ++n)
      if (touched[chains_[n].a] && touched[chains_[n].b]) present[n] = 0;
    const auto found = collect<std::uint32_t>(mesh_.tets.size(), [&](std::size_t i,
                                                                     std::vector<std::uint32_t>& pieces) {
      const TetId t(i);
      if (!mesh_.alive(t) || mesh_.ghost(t)) return;
      const auto& v = mesh_.tets[t];
      if (touched[v[0].index()] + touched[v[1].index()] + touched[v[2].index()] + touched[v[3].index()] < 2)
        return;
      for (const auto& e : kTetEdge) {
        if (!touched[v[e[0]].index()] || !touched[v[e[1]].index()]) continue;
        if (const std::uint32_t n = chains_.find(v[e[0]], v[e[1]]); n != UINT32_MAX) pieces.push_back(n);
      }
    });
    for (const std::uint32_t n : found) present[n] = 1;
    std::fill(touched.begin(), touched.end(), std::uint8_t{0});
    for (std::uint32_t n = 0; n < present.size(); ++n)
      if (!present[n]) add_piece(GapKind::kMissingPiece, n);
  }

  void add_piece(GapKind kind, std::uint32_t n) {
    const EdgePiece& p = chains_[n];
    Gap gap;
    gap.kind = kind;
    gap.entity = model_edge(p.edge);
    gap.place = 0.5 * (mesh_.points[VertexId(p.a)] + mesh_.points[VertexId(p.b)]);
    gap.piece = n;
    gaps_.push_back(gap);
  }

  void add_facet(GapKind kind, std::uint32_t n, ModelRef entity) {
    const BoundaryFacet& f = (*facets_)[n];
    Gap gap;
    gap.kind = kind;
    gap.place = (mesh_.points[f.v[0]] + mesh_.points[f.v[1]] + mesh_.points[f.v[2]]) / 3.0;
    gap.entity = entity;
    for (int i = 0; i < 3 && !gap.entity.valid(); ++i)
      if (on_[f.v[i].index()].dim == 2) gap.entity = on_[f.v[i].index()];
    for (int i = 0; i < 3 && !gap.entity.valid(); ++i)
      if (on_[f.v[i].index()].dim < 2) gap.entity = on_[f.v[i].index()];
    gap.tet = f.tet;
    gap.local = f.local;
    gaps_.push_back(gap);
  }

  /// Edges at plain vertices join two facets on one face and are no pieces: of the others more is asked.
  void edges() {
    const auto is_plain = [&](std::uint32_t v) { return memory_.fans_[v] == GapMemory::kPlain; };
    const std::vector<EdgeUseOfFacet> uses = edge_uses(is_plain, *facets_);
    std::vector<std::uint8_t> seen(chains_.pieces().size(), 0);
    for (const Gap& missing : gaps_)
      if (missing.kind == GapKind::kMissingPiece) seen[missing.piece] = 1;
    std::vector<int> faces;
    for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
      faces.clear();
      for (; j < uses.size() && same_edge(uses[i], uses[j]); ++j)
        faces.push_back((*facets_)[uses[j].facet].face);
      std::sort(faces.begin(), faces.end());
      if (faces[0] == 0) {  // reported as kNoFace
        const std::uint32_t n = piece_at(VertexId(uses[i].a), VertexId(uses[i].b));
        if (n != UINT32_MAX) seen[n] = 1;
        continue;
      }
      edge_group(uses, i, j, faces, seen);
    }
    for (std::uint32_t n = 0; n < seen.size(); ++n)
      if (!seen[n] && !memory_.expected_->at_edge(chains_[n].edge).empty()) add_piece(GapKind::kEdgeFan, n);
  }

  void edge_group(const std::vector<EdgeUseOfFacet>& uses, std::size_t i, std::size_t j,
                  const std::vector<int>& faces, std::vector<std::uint8_t>& seen) {
    const std::uint32_t piece = piece_at(VertexId(uses[i].a), VertexId(uses[i].b));
    if (piece != UINT32_MAX) {
      seen[piece] = 1;
      if (!std::ranges::equal(faces, memory_.expected_->at_edge(chains_[piece].edge)))
        add_piece(GapKind::kEdgeFan, piece);
      return;
    }
    if (faces.size() == 2 && faces[0] == faces[1]) return;
    for (std::size_t k = i; k < j; ++k)
      add_facet(GapKind::kEdgeFan, uses[k].facet, model_face((*facets_)[uses[k].facet].face));
  }

  struct BrokenFan {
    VertexId vertex;
    std::uint32_t facet;  ///< the worst there
  };
  /// What count_loops() finds, and works in.
  struct Fan {
    int components = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes;
    std::vector<int> open;
    std::vector<std::uint32_t> parent;
    std::vector<int> has_end;
  };

  /// Facets around each vertex, joined over edges that are no pieces, must be one disk on a face and paths
  /// between pieces elsewhere; closed fans are right only where a face holds the vertex without an edge
  /// (apex, pole). Remembers those that are as they should be.
  [[nodiscard]] std::vector<BrokenFan> broken_fans(const FacetsAtVertices& around) {
    return joined(
        map_blocks<std::vector<BrokenFan>>(on_.size(), kScanBlock, [&](std::size_t first, std::size_t last) {
          std::vector<BrokenFan> found;
          Fan fan;
          for (std::size_t i = first; i < last; ++i) {
            const VertexId v(i);
            const std::span<const std::uint32_t> facets = around[v];
            if (facets.empty()) continue;
            if (is_ring(v, facets, fan))
              memory_.fans_[i] = are_on_one_face(facets) ? GapMemory::kPlain : GapMemory::kWhole;
            else if (is_whole(v, facets, fan))
              memory_.fans_[i] = GapMemory::kWhole;
            else
              found.push_back({v, worst_of(facets)});
          }
          return found;
        }));
  }

  void vertices(const FacetsAtVertices& around, const std::vector<BrokenFan>& broken) {
    for (const BrokenFan& fan : broken) add_facet(GapKind::kVertexFan, fan.facet, on_[fan.vertex.index()]);
    for (std::uint32_t v = 0; v < on_.size(); ++v)
      if (on_[v].dim == 2 && is_asked(v) && around[VertexId(v)].empty() && !model_.is_outside(on_[v].tag)) {
        Gap gap;
        gap.kind = GapKind::kBareVertex;
        gap.entity = on_[v];
        gap.place = mesh_.points[VertexId(v)];
        gap.vertex = VertexId(v);
        gaps_.push_back(gap);
      }
  }

  /// Whether the facets around a vertex within a face are one disk, each edge at the vertex being of two of
  /// them that turn the same way: what nearly all are, and told sooner than the loops are counted.
  [[nodiscard]] bool is_ring(VertexId v, std::span<const std::uint32_t> facets, Fan& fan) const {
    if (on_[v.index()].dim != 2) return false;
    auto& spokes = fan.spokes;  // from, to
    spokes.clear();
    for (const std::uint32_t n : facets) {
      const auto& c = (*facets_)[n].v;
      const std::size_t own = c[0] == v ? 0 : c[1] == v ? 1 : 2;
      spokes.emplace_back(c[(own + 1) % 3].index(), c[(own + 2) % 3].index());
    }
    // Each facet is followed by the first that begins where it ends: if all are met, so is each edge once.
    std::size_t met = 0, at = 0;
    do {
      std::size_t next = 0;
      while (next < spokes.size() && spokes[next].first != spokes[at].second) ++next;
      if (next == spokes.size()) return false;
      at = next;
      ++met;
    } while (at != 0 && met <= spokes.size());
    return met == spokes.size();
  }

  [[nodiscard]] bool are_on_one_face(std::span<const std::uint32_t> facets) const {
    const std::int32_t face = (*facets_)[facets.front()].face;
    return face != 0 && std::all_of(facets.begin(), facets.end(),
                                    [&](std::uint32_t n) { return (*facets_)[n].face == face; });
  }

  /// Only a closed face without edges of its own can be missed as a whole: what has edges has their gaps.
  void bare_faces() {
    std::vector<std::uint8_t> covered(static_cast<std::size_t>(model_.count(2)) + 1, 0);
    for (const BoundaryFacet& f : *facets_) covered[static_cast<std::size_t>(f.face)] = 1;
    for (int face = 1; face <= model_.count(2); ++face)
      if (model_.is_outside(face)) covered[static_cast<std::size_t>(face)] = 1;
    if (std::find(covered.begin() + 1, covered.end(), 0) == covered.end()) return;
    const Facets& exact = model_.facets();
    std::vector<std::size_t> first(covered.size(), exact.face.size());
    for (std::size_t t = exact.face.size(); t-- > 0;) first[static_cast<std::size_t>(exact.face[t])] = t;
    for (int face = 1; face <= model_.count(2); ++face) {
      const auto f = static_cast<std::size_t>(face);
      if (covered[f] || first[f] == exact.face.size()) continue;
      Gap gap;
      gap.kind = GapKind::kBareFace;
      gap.entity = model_face(face);
      gap.place = facet_corners(exact, first[f])[0];
      gaps_.push_back(gap);
    }
  }

  /// Whether the facets around a vertex are as they should be, or not so in a way that is reported elsewhere.
  [[nodiscard]] bool is_whole(VertexId v, std::span<const std::uint32_t> around, Fan& fan) const {
    const ModelRef on = on_[v.index()];
    if (on.dim > 2) return true;  // an octree vertex on the boundary: its facets are reported as kNoFace
    const int loops = count_loops(v, around, fan);
    int expected = 0;
    if (on.dim == 2) expected = 1;
    if (on.dim == 0) expected = memory_.expected_->edgeless_at(on.tag);
    if (loops == expected && (on.dim != 2 || fan.components == 1)) return true;
    return loops < 0;  // an edge with other than two facets: reported as kEdgeFan
  }

  /// The first of the facets with the largest circumradius.
  [[nodiscard]] std::uint32_t worst_of(std::span<const std::uint32_t> facets) const {
    return *std::max_element(facets.begin(), facets.end(), [&](std::uint32_t a, std::uint32_t b) {
      return facet_radius((*facets_)[a]) < facet_radius((*facets_)[b]);
    });
  }

  /// Number of closed fans of facets around v (joined over non-piece edges); -1 when an edge joins other than
  /// two.
  int count_loops(VertexId v, std::span<const std::uint32_t> around, Fan& fan) const {
    // spokes: the far ends of the edges at v that are no pieces, with the facets that use them.
    auto& [components, spokes, open, parent, has_end] = fan;
    spokes.clear();
    open.assign(around.size(), 0);
    for (std::uint32_t k = 0; k < around.size(); ++k)
      for (const VertexId w : (*facets_)[around[k]].v) {
        if (w == v) continue;
        if (piece_at(v, w) != UINT32_MAX)
          open[k] = 1;
        else
          spokes.emplace_back(w.index(), k);
      }
    std::sort(spokes.begin(), spokes.end());
    parent.resize(around.size());
    for (std::uint32_t k = 0; k < parent.size(); ++k) parent[k] = k;
    const auto root = [&parent = fan.parent](std::uint32_t k) {
      while (parent[k] != k) k = parent[k] = parent[parent[k]];
      return k;
    };
    for (std::size_t i = 0; i < spokes.size(); i += 2) {
      if (i + 1 >= spokes.size() || spokes[i].first != spokes[i + 1].first) return -1;
      if (i + 2 < spokes.size() && spokes[i + 2].first == spokes[i].first) return -1;
      parent[root(spokes[i].second)] = root(spokes[i + 1].second);
    }
    has_end.assign(around.size(), 0);
    for (std::uint32_t k = 0; k < around.size(); ++k) has_end[root(k)] |= open[k];
    int loops = 0;
    components = 0;
    for (std::uint32_t k = 0; k < around.size(); ++k) {
      if (parent[k] != k) continue;
      ++components;
      loops += !has_end[k];
    }
    return loops;
  }

  [[nodiscard]] double facet_radius(const BoundaryFacet& f) const {
    const Vec3 a = mesh_.points[f.v[0]], b = mesh_.points[f.v[1]], c = mesh_.points[f.v[2]];
    const double area = (b - a).cross(c - a).norm();
    return (b - a).norm() * (c - b).norm() * (a - c).norm() / std::max(2.0 * area, 1e-300);
  }

  const Model& model_;
  const TetMesh& mesh_;
  std::span<const ModelRef> on_;
  const EdgeChains& chains_;
  Band& band_;
  GapMemory& memory_;
  const std::vector<BoundaryFacet>* facets_ = nullptr;
  std::vector<Gap> gaps_;
};

std::vector<Gap> find_gaps(Band& band, const TetMesh& mesh, std::span<const ModelRef> on,
                           const EdgeChains& chains, GapScope scope) {
  GapMemory nothing;
  return GapFinder(band, mesh, on, chains, nothing).run(scope);
}

std::vector<Gap> find_gaps(Band& band, const TetMesh& mesh, std::span<const ModelRef> on,
                           const EdgeChains& chains, GapMemory& memory, GapScope scope) {
  return GapFinder(band, mesh, on, chains, memory).run(scope);
}

AttributePoint split_point(const Model& model, const TetMesh& mesh, std::span<const ModelRef> on,
                           const EdgePiece& piece) {
  const bool vertex_a = on[piece.a].dim == 0, vertex_b = on[piece.b].dim == 0;
  const double length = model.edge_length(piece.edge, piece.ta, piece.tb);
  double from_a = 0.5 * length;
  if (vertex_a != vertex_b) {
    // The one power of two in (0.35, 0.7] of the length: edges that meet at the vertex are split on the same
    // shells.
    const double shell = std::exp2(std::floor(std::log2(0.7 * length)));
    from_a = vertex_a ? shell : length - shell;
  }
  AttributePoint p;
  p.t = model.edge_parameter(piece.edge, piece.ta, from_a);
  if (!(p.t > piece.ta && p.t < piece.tb)) p.t = 0.5 * (piece.ta + piece.tb);
  p.point = model.edge_point(piece.edge, p.t);
  p.on = model_edge(piece.edge);
  p.clearance = std::min((p.point - mesh.points[VertexId(piece.a)]).norm(),
                         (p.point - mesh.points[VertexId(piece.b)]).norm());
  return p;
}

namespace {

/// Adds what parts the circumcentre of a tetrahedron from its octree vertices: a thin sheet without points
/// lets a tetrahedron reach through it from the far side.
void meet_towards_octree_vertices(const Model& model, const TetMesh& mesh, std::span<const ModelRef> on,
                                  TetId tet, std::vector<Hit>& hits) {
  if (mesh.ghost(tet)) return;
  const auto& corners = mesh.tets[tet];
  const Circumcentre c = circumcentre(mesh, tet);
  if (!c.reliable) return;
  std::vector<Hit> between;
  for (const VertexId v : corners) {
    if (on[v.index()].dim != 3) continue;
    between.clear();
    model.intersect(c.point, mesh.points[v], between);
    if (between.size() % 2 == 1) hits.insert(hits.end(), between.begin(), between.end());
  }
}

/// Of crossings with faces that which is farthest from the corners on the boundary; none when all are closer
/// than `floor` to one.
std::optional<AttributePoint> farthest_on_a_face(const TetMesh& mesh, std::span<const ModelRef> on,
                                                 std::span<const VertexId> corners,
                                                 const std::vector<Hit>& hits, double floor) {
  std::optional<AttributePoint> best;
  for (const Hit& hit : hits) {
    if (hit.on.dim != 2) continue;
    double clearance = std::numeric_limits<double>::infinity();
    for (const VertexId v : corners)
      if (on[v.index()].dim < 3) clearance = std::min(clearance, (hit.point - mesh.points[v]).norm());
    if (clearance < floor || (best && clearance <= best->clearance)) continue;
    best = AttributePoint{hit.point, hit.on, 0.0, hit.normal, clearance};
  }
  return best;
}

}  // namespace

std::optional<AttributePoint> facet_point(const Model& model, const TetMesh& mesh,
                                          std::span<const ModelRef> on, TetId tet, int local, double floor) {
  const auto& v = mesh.tets[tet];
  const std::array<Vec3, 3> x{mesh.points[v[kTetFace[local][0]]], mesh.points[v[kTetFace[local][1]]],
                              mesh.points[v[kTetFace[local][2]]]};
  const Vec3 centroid = (x[0] + x[1] + x[2]) / 3.0;
  const double reach =
      std::max({(x[0] - centroid).norm(), (x[1] - centroid).norm(), (x[2] - centroid).norm()});
  const DualSegment dual = dual_segment(mesh, tet, local);
  std::vector<Hit> hits;
  model.intersect(dual.inner, dual.outer, hits);
  meet_towards_octree_vertices(model, mesh, on, tet, hits);
  meet_towards_octree_vertices(model, mesh, on, mesh.neighbours[tet][local], hits);
  std::optional<AttributePoint> best;
  const auto offer = [&](const Vec3& p, ModelRef entity, const Vec3& n) {
    double clearance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const double distance = (p - x[i]).norm();
      // What the CAD cannot tell apart is one place.
      if (distance < 2.0 * model.tolerance_of(on[v[kTetFace[local][i]].index()])) return;
      clearance = std::min(clearance, distance);
    }
    if (clearance < floor || (best && clearance <= best->clearance)) return;
    best = AttributePoint{p, entity, 0.0, n, clearance};
    if (entity.dim == 1) best->t = model.edge_closest(entity.tag, p).t;
  };
  for (const Hit& hit : hits)
    if (hit.on.dim >= 1) offer(hit.point, hit.on, hit.normal);
  if (best) return best;
  if (const auto foot = model.closest(centroid, 4.0 * reach); foot && foot->on.dim >= 1)
    offer(foot->point, foot->on, foot->normal);
  return best;
}

std::optional<AttributePoint> reach_point(const Model& model, const TetMesh& mesh,
                                          std::span<const ModelRef> on, TetId tet, double floor) {
  std::vector<Hit> hits;
  meet_towards_octree_vertices(model, mesh, on, tet, hits);
  return farthest_on_a_face(mesh, on, mesh.tets[tet], hits, floor);
}

std::optional<AttributePoint> hidden_sheet_point(const Model& model, const TetMesh& mesh,
                                                 std::span<const ModelRef> on, TetId tet, int local,
                                                 bool is_facet, double floor) {
  const DualSegment dual = dual_segment(mesh, tet, local);
  std::vector<Hit> hits;
  model.intersect(dual.inner, dual.outer, hits);
  if (hits.size() <= static_cast<std::size_t>(is_facet)) return std::nullopt;
  const auto& v = mesh.tets[tet];
  const std::array<VertexId, 3> corners{v[kTetFace[local][0]], v[kTetFace[local][1]], v[kTetFace[local][2]]};
  return farthest_on_a_face(mesh, on, corners, hits, floor);
}

namespace {

/// The gap in the user's terms.
Fault describe_gap(const Model& model, const Gap& gap) {
  Fault fault;
  fault.entity = gap.entity;
  fault.place = gap.place;
  const std::string who = model.describe(gap.entity);
  switch (gap.kind) {
    case GapKind::kMissingPiece:
      fault.cause = who + " is not covered by a chain of mesh edges";
      break;
    case GapKind::kNoFace:
      fault.cause = "a mesh face at " + who + " lies on no model face";
      break;
    case GapKind::kEdgeFan:
      fault.cause = "mesh faces around an edge at " + who + " do not match the model's faces";
      break;
    case GapKind::kVertexFan:
      fault.cause = "mesh faces around a vertex on " + who + " form no disk";
      break;
    case GapKind::kBareVertex:
      fault.cause = who + " is not covered by mesh faces around a point on it";
      break;
    case GapKind::kBareFace:
      fault.cause = "no mesh face lies on " + who;
      break;
    case GapKind::kDualCrossing:
      fault.cause = "a mesh face on " + who + " stands for more than one sheet of the boundary";
      break;
  }
  fault.advice =
      "ask for a smaller size here, or take away small features (--defeature) or the thin wall at this place";
  return fault;
}

}  // namespace

std::vector<Fault> describe_gaps(const Model& model, std::span<const Gap> gaps) {
  struct Like {
    std::size_t fault;  ///< index of the fault that stands for them
    std::size_t count;
  };
  std::map<std::pair<ModelRef, GapKind>, Like> known;
  std::vector<Fault> faults;
  for (const Gap& gap : gaps) {
    const auto [like, is_new] = known.try_emplace({gap.entity, gap.kind}, Like{faults.size(), 0});
    if (is_new) faults.push_back(describe_gap(model, gap));
    ++like->second.count;
  }
  for (const auto& [what, like] : known)
    if (like.count > 1) faults[like.fault].cause += fmt::format(", and so at {} more places", like.count - 1);
  return faults;
}

}  // namespace octet
