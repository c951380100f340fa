// SPDX-License-Identifier: BSD-3-Clause
// The passes that raise the mean: sweeps of smoothing and of swaps over all but the lattice's own tetrahedra.
#include "finalize/relax.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include "finalize/cavity.h"
#include "finalize/collapse.h"
#include "finalize/edge_removal.h"
#include "finalize/edge_slots.h"
#include "finalize/mean_smooth.h"
#include "finalize/smooth.h"

namespace octet {
namespace {

/// Tetrahedra of better shape than this (54.3 degrees) are left alone: those of the lattice have 60.
constexpr double kGoodEnough = 0.66;
/// What a vertex's move of this share of an edge disturbs is smoothed again in the next sweep.
constexpr double kDisturbs = 0.1;

/// Tetrahedra of worse shape than this (42 degrees) may lose an edge that is shorter than this share of the
/// size.
constexpr double kCollapseBelow = 0.45;
constexpr double kShortEdge = 0.75;

/// Swaps for the mean: edges are tried that have a tetrahedron of worse shape than this (48 degrees), and no
/// more than so many. Of 100 000 removals for the mean on a bracket, all of rings above four and of better
/// shapes together won a thousandth.
constexpr double kSwapBelow = 0.55;
constexpr std::size_t kLargestRing = 4;

/// The tetrahedra at each of the vertices, for the while that topology stays as it is.
class Stars {
 public:
  Stars(const WorkMesh& mesh, const std::vector<VertexId>& vertices)
      : wanted_(mesh.points.size(), 0), start_(mesh.points.size() + 1, 0) {
    for (const VertexId v : vertices) wanted_[v.index()] = 1;
    for_each(mesh, [&](std::size_t v, TetId) { ++start_[v + 1]; });
    for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
    tets_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for_each(mesh, [&](std::size_t v, TetId t) { tets_[next[v]++] = t; });
  }
  [[nodiscard]] std::span<const TetId> of(VertexId v) const {
    return {tets_.data() + start_[v.index()], tets_.data() + start_[v.index() + 1]};
  }

 private:
  template <class Visit>
  void for_each(const WorkMesh& mesh, const Visit& visit) const {
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      if (!mesh.alive(TetId(i))) continue;
      for (const VertexId v : mesh.tets[TetId(i)])
        if (wanted_[v.index()] != 0) visit(v.index(), TetId(i));
    }
  }
  std::vector<char> wanted_;
  std::vector<std::size_t> start_;
  std::vector<TetId> tets_;
};

std::vector<VertexId> vertices_to_relax(const WorkMesh& mesh) {
  std::vector<char> wanted(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.quality[t] >= kGoodEnough) continue;
    for (const VertexId v : mesh.tets[t]) wanted[v.index()] = 1;
  }
  std::vector<VertexId> vertices;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] && may_move(mesh, VertexId(i))) vertices.emplace_back(i);
  }
  return vertices;
}

/// Lists of vertices such that no two of a list share a tetrahedron: each takes, in the order of the numbers,
/// the first list that no neighbour is in, or, after many lists, one of its own.
std::vector<std::vector<VertexId>> coloured(const WorkMesh& mesh, const Stars& stars,
                                            const std::vector<VertexId>& vertices) {
  std::vector<std::vector<VertexId>> lists, alone;
  std::vector<std::uint64_t> taken(mesh.tets.size(), 0);  // the lists of a tetrahedron's vertices, a bit each
  for (const VertexId v : vertices) {
    std::uint64_t near = 0;
    for (const TetId t : stars.of(v)) near |= taken[t.index()];
    const std::size_t list = static_cast<std::size_t>(std::countr_one(near));
    if (list == 64) {
      alone.push_back({v});
      continue;
    }
    if (list == lists.size()) lists.emplace_back();
    lists[list].push_back(v);
    for (const TetId t : stars.of(v)) taken[t.index()] |= std::uint64_t{1} << list;
  }
  std::move(alone.begin(), alone.end(), std::back_inserter(lists));
  return lists;
}

/// Moves the vertices of one list; those on or beside curved faces one after the other, for they share the
/// account of the volumes. Marks in `disturbed` what is to be smoothed again, where that is asked for.
void relax_list(Workshop& shop, const Stars& stars, const std::vector<VertexId>& list, double floor,
                std::vector<char>* disturbed) {
  std::vector<MeanMove> moves(list.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, list.size(), 256), [&](const auto& range) {
    LocalStar star;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const std::span<const TetId> tets = stars.of(list[i]);
      MeanMove& move = moves[i];
      move = mean_move(shop, list[i], tets, floor, star);
      if (move.step == 0.0 || !move.changes.empty()) continue;
      if (!move_vertex(shop.mesh, list[i], move.stand.point, tets, {star.bases.shapes(), tets.size()}))
        move.step = 0.0;
    }
  });
  for (std::size_t i = 0; i < list.size(); ++i) {
    const MeanMove& move = moves[i];
    shop.work += move.work;
    if (move.step == 0.0) continue;
    if (!move.changes.empty()) {
      if (!commit_move(shop, list[i], stars.of(list[i]), move.stand, move.changes, move.shapes)) continue;
    } else {
      record_stand(shop, list[i], move.stand);
      ++shop.report.smoothed;
    }
    if (disturbed == nullptr || move.step < kDisturbs) continue;
    for (const TetId t : stars.of(list[i])) {
      for (const VertexId w : shop.mesh.tets[t]) (*disturbed)[w.index()] = 1;
    }
  }
}

/// Into an order in which neighbours do not follow each other: in rows along the surface each operation
/// answers the one before, and a plate's mean ratio falls by a hundredth.
void scatter(std::vector<TetId>& tets) {
  const auto place = [](TetId t) { return t.index() * 2654435769u; };  // one to one
  std::sort(tets.begin(), tets.end(), [&](TetId a, TetId b) { return place(a) < place(b); });
}

/// Whether edge e of t may have a ring of no more than kLargestRing tetrahedra: two steps to either side of t
/// tell. Most have more, and are spared the walk.
bool has_small_ring(const WorkMesh& mesh, TetId t, int e) {
  static_assert(kLargestRing == 4);
  const auto [c, d] = kTetEdge[5 - e];  // the other two vertices; the ring goes on across from each
  const TetId p = mesh.neighbours[t][c], q = mesh.neighbours[t][d];
  if (!p.valid() || !q.valid() || p == q) return true;
  const TetId beyond_p = mesh.neighbours[p][corner_of(mesh, p, mesh.tets[t][d])];
  const TetId beyond_q = mesh.neighbours[q][corner_of(mesh, q, mesh.tets[t][c])];
  return !beyond_p.valid() || !beyond_q.valid() || beyond_p == q || beyond_p == beyond_q;
}

/// Whether an edge of t that t is the worst tetrahedron of, the first where there are several, can be removed
/// for the mean, judged by the shapes alone.
bool may_swap(const Workshop& shop, TetId t, double floor, EdgeRing& ring) {
  const WorkMesh& mesh = shop.mesh;
  const auto& v = mesh.tets[t];
  const auto& n = mesh.neighbours[t];
  const auto is_no_worse = [&](TetId s) {
    return std::tie(mesh.quality[t], t) <= std::tie(mesh.quality[s], s);
  };
  // Neighbours first: few edges are left whose rings are walked.
  std::array<bool, 4> beside{};
  for (int f = 0; f < 4; ++f) beside[f] = !n[f].valid() || is_no_worse(n[f]);
  for (int e = 0; e < 6; ++e) {
    const auto &ends = kTetEdge[e], &faces = kTetEdge[5 - e];  // the opposite edge's vertices face these
    if (!beside[faces[0]] || !beside[faces[1]] || !has_small_ring(mesh, t, e)) continue;
    if (edge_ring(mesh, t, v[ends[0]], v[ends[1]], ring, kLargestRing) &&
        std::all_of(ring.tets.begin(), ring.tets.end(), is_no_worse) &&
        edge_removal_raises_mean(shop, ring, floor))
      return true;
  }
  return false;
}

bool swap_something(Workshop& shop, TetId t, double floor) {
  const auto v = shop.mesh.tets[t];
  for (int e = 0; e < 6; ++e) {
    if (has_small_ring(shop.mesh, t, e) &&
        edge_ring(shop.mesh, t, v[kTetEdge[e][0]], v[kTetEdge[e][1]], shop.ring, kLargestRing) &&
        remove_edge_for_mean(shop, shop.ring, floor))
      return true;
  }
  return false;
}

}  // namespace

void relax_for_mean(Workshop& shop, double floor, int sweeps) {
  const std::vector<VertexId> vertices = vertices_to_relax(shop.mesh);
  const Stars stars(shop.mesh, vertices);
  const auto lists = coloured(shop.mesh, stars, vertices);
  std::vector<char> active(shop.mesh.points.size(), 1), disturbed(active.size(), 0);
  std::vector<VertexId> list;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::fill(disturbed.begin(), disturbed.end(), 0);
    for (const auto& all : lists) {
      list.clear();
      std::copy_if(all.begin(), all.end(), std::back_inserter(list),
                   [&](VertexId v) { return active[v.index()] != 0; });
      relax_list(shop, stars, list, floor, sweep + 1 < sweeps ? &disturbed : nullptr);
    }
    active.swap(disturbed);
  }
  shop.forget_failures();
}

void collapse_for_mean(Workshop& shop, double floor) {
  const WorkMesh& mesh = shop.mesh;
  std::vector<TetId> bad;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    if (mesh.alive(TetId(i)) && mesh.quality[TetId(i)] < kCollapseBelow) bad.emplace_back(i);
  scatter(bad);
  // A third of the edges of a bracket had been tried in vain before, from another bad tetrahedron.
  constexpr int kSlotBits = 16;
  EdgeSlots<std::uint32_t> tried(kSlotBits);
  for (const TetId t : bad) {
    if (!mesh.alive(t) || mesh.quality[t] >= kCollapseBelow) continue;
    const double short_edge = kShortEdge * shop.size_at(mesh.point(t, 0));
    const auto v = mesh.tets[t];
    for (const auto& e : kTetEdge) {
      const VertexId a = v[e[0]], b = v[e[1]];
      if ((mesh.points[a] - mesh.points[b]).squaredNorm() > short_edge * short_edge) continue;
      const std::uint32_t* when = tried.find(a, b);
      if (when != nullptr && shop.unchanged_since(*when, a) && shop.unchanged_since(*when, b)) continue;
      if (collapse_edge_for_mean(shop, a, b, floor) || collapse_edge_for_mean(shop, b, a, floor)) {
        shop.note_change();
        break;
      }
      tried.set(a, b, ++shop.serial);
    }
  }
}

void swap_for_mean(Workshop& shop, double floor) {
  WorkMesh& mesh = shop.mesh;
  std::vector<char> wanted(mesh.tets.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.tets.size(), 64), [&](const auto& range) {
    EdgeRing ring;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TetId t(i);
      wanted[i] = mesh.alive(t) && mesh.quality[t] < kSwapBelow && may_swap(shop, t, floor, ring);
    }
  });
  std::vector<TetId> queue;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) queue.emplace_back(i);
  }
  scatter(queue);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (!mesh.alive(queue[i]) || !swap_something(shop, queue[i], floor)) continue;
    for (const TetId made : shop.made) {
      if (mesh.quality[made] < kSwapBelow) queue.push_back(made);
    }
  }
  shop.forget_failures();
}

}  // namespace octet
