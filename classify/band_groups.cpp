// SPDX-License-Identifier: BSD-3-Clause
// Misfits that no single move cures: the labels of a group of tetrahedra are chosen together.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "base/blocks.h"
#include "classify/band.h"
#include "classify/min_cut.h"
#include "mesh/circumcentre.h"

namespace octet {
namespace {

/// A group reaches this many faces away from a misfit, and holds at most so many tetrahedra.
constexpr int kRings = 4;
constexpr std::size_t kLargestGroup = 4000;
/// A misfit costs as much as this many circumcentres on the wrong side: few enough that a thin sheet whose
/// tetrahedra are all movable is not given away for a misfit or two.
constexpr std::int64_t kMisfitCost = 12;
/// So does a tetrahedron at a piece of an edge that lies on the wrong side of one of the edge's faces.
constexpr std::int64_t kBesideCost = 4;

/// Number of the piece along an edge of a tetrahedron, or UINT32_MAX.
std::uint32_t piece_of(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains, TetId t,
                       const int (&edge)[2]) {
  const VertexId a = mesh.tets[t][edge[0]], b = mesh.tets[t][edge[1]];
  return on[a.index()].dim > 1 || on[b.index()].dim > 1 ? UINT32_MAX : chains.find(a, b);
}

}  // namespace

std::size_t Band::repair(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains) {
  const std::size_t singly = repair_singly(mesh, on);
  return singly + repair_in_groups(mesh, on, chains);
}

std::size_t Band::repair_beside(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                                std::span<const std::uint32_t> pieces) {
  std::vector<std::uint8_t> wanted(chains.pieces().size(), 0), is_end(on.size(), 0);
  for (const std::uint32_t n : pieces) wanted[n] = is_end[chains[n].a] = is_end[chains[n].b] = 1;
  const auto around = collect<TetId>(mesh.tets.size(), [&](std::size_t i, std::vector<TetId>& found) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.ghost(t)) return;
    const auto& v = mesh.tets[t];
    if (std::count_if(v.begin(), v.end(), [&](VertexId w) { return is_end[w.index()] != 0; }) < 2) return;
    if (movable(mesh, on, t) && std::any_of(std::begin(kTetEdge), std::end(kTetEdge), [&](const auto& e) {
          const std::uint32_t n = piece_of(mesh, on, chains, t, e);
          return n != UINT32_MAX && wanted[n] != 0;
        }))
      found.push_back(t);
  });
  std::vector<std::uint8_t> taken(mesh.tets.size(), 0);
  std::size_t moved = 0;
  for (const TetId t : around) {
    if (taken[t.index()]) continue;
    for (const auto& e : kTetEdge) {
      const std::uint32_t n = piece_of(mesh, on, chains, t, e);
      if (n == UINT32_MAX) continue;
      const int first = region_[t], second = region_beside(mesh, t, chains[n]);
      if (first == second) continue;
      const std::vector<TetId> group = group_around(mesh, on, t, t, first, second, taken);
      moved += relabel_group(mesh, on, chains, group, first, second);
      break;
    }
  }
  return moved;
}

std::size_t Band::repair_in_groups(const TetMesh& mesh, std::span<const ModelRef> on,
                                   const EdgeChains& chains) {
  struct Pair {
    TetId a, b;
  };
  std::vector<Pair> misfits;
  for (const BoundaryFacet& facet : facets(mesh, on))
    if (facet.face == 0) misfits.push_back({facet.tet, mesh.neighbours[facet.tet][facet.local]});
  std::vector<std::uint8_t> taken(mesh.tets.size(), 0);
  std::size_t moved = 0;
  for (const auto& [a, b] : misfits) {
    const int first = region_[a], second = region_[b];
    if (first == second || taken[a.index()] || taken[b.index()]) continue;
    const std::vector<TetId> group = group_around(mesh, on, a, b, first, second, taken);
    if (!group.empty()) moved += relabel_group(mesh, on, chains, group, first, second);
  }
  return moved;
}

std::vector<TetId> Band::group_around(const TetMesh& mesh, std::span<const ModelRef> on, TetId a, TetId b,
                                      int first, int second, std::vector<std::uint8_t>& taken) const {
  std::vector<TetId> group;
  const auto take = [&](TetId t) {
    if (taken[t.index()] || (region_[t] != first && region_[t] != second) || !movable(mesh, on, t)) return;
    taken[t.index()] = 1;
    group.push_back(t);
  };
  take(a);
  take(b);
  std::size_t from = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const std::size_t to = group.size();
    for (; from < to && group.size() < kLargestGroup; ++from)
      for (const TetId n : mesh.neighbours[group[from]]) take(n);
  }
  return group;
}

/// Region of a place beside a piece of an edge, between the other two corners of a tetrahedron at it: nearer
/// to these than to the piece, since at a cusp the region is thinner than the tetrahedron near the edge.
int Band::region_beside(const TetMesh& mesh, TetId t, const EdgePiece& piece) const {
  constexpr double kShare = 0.3;
  const Vec3 on_edge = model_->edge_point(piece.edge, 0.5 * (piece.ta + piece.tb));
  Vec3 across = Vec3::Zero();
  for (const VertexId v : mesh.tets[t])
    if (v.index() != piece.a && v.index() != piece.b) across += 0.5 * mesh.points[v];
  return region_of_(kShare * on_edge + (1.0 - kShare) * across);
}

Band::Voice Band::voice_of(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                           TetId t) const {
  const Circumcentre c = circumcentre(mesh, t);
  Voice voice{c.reliable ? region_of_(c.point) : kNowhere, {}};
  for (std::size_t e = 0; e < voice.beside.size(); ++e) {
    const std::uint32_t n = piece_of(mesh, on, chains, t, kTetEdge[e]);
    voice.beside[e] = n == UINT32_MAX ? kNowhere : region_beside(mesh, t, chains[n]);
  }
  return voice;
}

/// Regions of places take most of a repair's time, and most groups are met again in the next round: they are
/// kept as long as their tetrahedron.
void Band::hear(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                const std::vector<TetId>& group) {
  std::vector<TetId> missing;
  for (const TetId t : group)
    if (voice_.count(t.index()) == 0) missing.push_back(t);
  std::vector<Voice> voices(missing.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, missing.size(), 16), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      voices[i] = voice_of(mesh, on, chains, missing[i]);
  });
  for (std::size_t i = 0; i < missing.size(); ++i) voice_.emplace(missing[i].index(), voices[i]);
}

std::size_t Band::relabel_group(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                                const std::vector<TetId>& group, int first, int second) {
  std::map<TetId, std::uint32_t> node;
  for (const TetId t : group) node.emplace(t, static_cast<std::uint32_t>(node.size()));
  const auto cost = [&](TetId t, std::int8_t f, int behind, int front) {
    return misfit(mesh, on, t, f, behind, front) ? kMisfitCost : 0;
  };
  hear(mesh, on, chains, group);
  TwoLabels labels(group.size());  // 0: first, 1: second
  for (std::uint32_t i = 0; i < group.size(); ++i) {
    const TetId t = group[i];
    const Voice& voice = voice_.at(t.index());
    const int natural = voice.circumcentre == kNowhere ? region_[t] : voice.circumcentre;
    labels.prefer(i, natural == second, natural == first);
    for (std::size_t e = 0; e < voice.beside.size(); ++e) {
      const int beside = voice.beside[e];
      if (beside == kNowhere || piece_of(mesh, on, chains, t, kTetEdge[e]) == UINT32_MAX) continue;
      labels.prefer(i, beside == second ? kBesideCost : 0, beside == first ? kBesideCost : 0);
    }
    for (std::int8_t f = 0; f < 4; ++f) {
      const TetId n = mesh.neighbours[t][f];
      const auto inside = node.find(n);
      if (inside == node.end())
        labels.prefer(i, cost(t, f, first, region_[n]), cost(t, f, second, region_[n]));
      else if (i < inside->second)
        labels.join(i, inside->second, cost(t, f, first, second), cost(t, f, second, first));
    }
  }
  const std::vector<std::uint8_t> chosen = labels.solve();
  std::size_t moved = 0;
  for (std::uint32_t i = 0; i < group.size(); ++i) {
    const int region = chosen[i] == 0 ? first : second;
    if (region == region_[group[i]]) continue;
    move(mesh, group[i], region);
    ++moved;
  }
  return moved;
}

}  // namespace octet
