// SPDX-License-Identifier: BSD-3-Clause
// Misfits that no single move cures: the labels of a group of tetrahedra are chosen together.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

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
  Groups groups(mesh.tets.size());
  for (const TetId t : around) {
    if (groups.has(t)) continue;
    for (const auto& e : kTetEdge) {
      const std::uint32_t n = piece_of(mesh, on, chains, t, e);
      if (n == UINT32_MAX) continue;
      const int first = region_[t], second = region_beside(mesh, t, chains[n]);
      if (first == second) continue;
      add_group(mesh, on, t, t, {first, second, {}}, groups);
      break;
    }
  }
  return relabel(mesh, on, chains, groups);
}

std::size_t Band::repair_in_groups(const TetMesh& mesh, std::span<const ModelRef> on,
                                   const EdgeChains& chains) {
  Groups groups(mesh.tets.size());
  for (const BoundaryFacet& facet : facets(mesh, on)) {
    if (facet.face != 0) continue;
    const TetId a = facet.tet, b = mesh.neighbours[facet.tet][facet.local];
    const int first = region_[a], second = region_[b];
    if (first != second && !groups.has(a) && !groups.has(b))
      add_group(mesh, on, a, b, {first, second, {}}, groups);
  }
  return relabel(mesh, on, chains, groups);
}

/// The tetrahedra around a and b that are in no group yet.
void Band::add_group(const TetMesh& mesh, std::span<const ModelRef> on, TetId a, TetId b, Group group,
                     Groups& groups) const {
  const auto number = static_cast<std::uint32_t>(groups.all.size());
  std::vector<TetId>& tets = group.tets;
  const auto take = [&](TetId t) {
    if (groups.has(t) || (region_[t] != group.first && region_[t] != group.second) || !movable(mesh, on, t))
      return;
    groups.of_tet[t.index()] = number;
    tets.push_back(t);
  };
  take(a);
  take(b);
  std::size_t from = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const std::size_t to = tets.size();
    for (; from < to && tets.size() < kLargestGroup; ++from)
      for (const TetId n : mesh.neighbours[tets[from]]) take(n);
  }
  if (!tets.empty()) groups.all.push_back(std::move(group));
}

/// Each group is labelled behind those before it that it touches, so that all come to what they would come to
/// one after the other.
std::size_t Band::relabel(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                          const Groups& groups) {
  hear(mesh, on, chains, groups.all);
  std::vector<std::uint32_t> turn(groups.all.size(), 0);
  std::vector<std::vector<std::uint32_t>> turns;
  for (std::uint32_t g = 0; g < groups.all.size(); ++g) {
    for (const TetId t : groups.all[g].tets)
      for (const TetId n : mesh.neighbours[t])
        if (const std::uint32_t other = groups.of_tet[n.index()]; other < g)
          turn[g] = std::max(turn[g], turn[other] + 1);
    if (turn[g] == turns.size()) turns.emplace_back();
    turns[turn[g]].push_back(g);
  }
  std::size_t moved = 0;
  for (const std::vector<std::uint32_t>& at_once : turns) {
    std::vector<std::vector<std::uint8_t>> chosen(at_once.size());
    tbb::parallel_for(std::size_t{0}, at_once.size(), [&](std::size_t i) {
      chosen[i] = labels_of(mesh, on, chains, groups.all[at_once[i]]);
    });
    for (std::size_t i = 0; i < at_once.size(); ++i) {
      const Group& group = groups.all[at_once[i]];
      for (std::size_t k = 0; k < group.tets.size(); ++k) {
        const int region = chosen[i][k] == 0 ? group.first : group.second;
        if (region == region_[group.tets[k]]) continue;
        move(mesh, group.tets[k], region);
        ++moved;
      }
    }
  }
  return moved;
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
                const std::vector<Group>& groups) {
  std::vector<TetId> missing;
  for (const Group& group : groups)
    for (const TetId t : group.tets)
      if (voice_.count(t.index()) == 0) missing.push_back(t);
  std::vector<Voice> voices(missing.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, missing.size(), 16), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      voices[i] = voice_of(mesh, on, chains, missing[i]);
  });
  for (std::size_t i = 0; i < missing.size(); ++i) voice_.emplace(missing[i].index(), voices[i]);
}

/// For each tetrahedron of the group whether it is to be in the first region (0) or in the second (1).
std::vector<std::uint8_t> Band::labels_of(const TetMesh& mesh, std::span<const ModelRef> on,
                                          const EdgeChains& chains, const Group& group) const {
  const std::vector<TetId>& tets = group.tets;
  std::map<TetId, std::uint32_t> node;
  for (const TetId t : tets) node.emplace(t, static_cast<std::uint32_t>(node.size()));
  const auto cost = [&](TetId t, std::int8_t f, int behind, int front) {
    return misfit(mesh, on, t, f, behind, front) ? kMisfitCost : 0;
  };
  TwoLabels labels(tets.size());  // 0: first, 1: second
  for (std::uint32_t i = 0; i < tets.size(); ++i) {
    const TetId t = tets[i];
    const Voice& voice = voice_.at(t.index());
    const int natural = voice.circumcentre == kNowhere ? region_[t] : voice.circumcentre;
    labels.prefer(i, natural == group.second, natural == group.first);
    for (std::size_t e = 0; e < voice.beside.size(); ++e) {
      const int beside = voice.beside[e];
      if (beside == kNowhere || piece_of(mesh, on, chains, t, kTetEdge[e]) == UINT32_MAX) continue;
      labels.prefer(i, beside == group.second ? kBesideCost : 0, beside == group.first ? kBesideCost : 0);
    }
    for (std::int8_t f = 0; f < 4; ++f) {
      const TetId n = mesh.neighbours[t][f];
      const auto inside = node.find(n);
      if (inside == node.end())
        labels.prefer(i, cost(t, f, group.first, region_[n]), cost(t, f, group.second, region_[n]));
      else if (i < inside->second)
        labels.join(i, inside->second, cost(t, f, group.first, group.second),
                    cost(t, f, group.second, group.first));
    }
  }
  return labels.solve();
}

}  // namespace octet
