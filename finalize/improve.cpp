// SPDX-License-Identifier: BSD-3-Clause
// The passes of finalization, made of the operators.
#include "finalize/improve.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <queue>
#include <tuple>

#include "base/error.h"
#include "base/sort_unique.h"
#include "finalize/collapse.h"
#include "finalize/compound.h"
#include "finalize/edge_removal.h"
#include "finalize/edge_slots.h"
#include "finalize/face_swap.h"
#include "finalize/shape.h"
#include "finalize/smooth.h"
#include "finalize/split.h"
#include "mesh/quality.h"

namespace octet {
namespace {

/// Below this an edge collapse may not leave anything, however bad what it removes was.
constexpr double kCollapseShape = 0.0302;  // ten degrees

struct Candidate {
  double rank;
  TetId tet;
  /// The lowest comes first, ties by number.
  bool operator<(const Candidate& other) const {
    return std::tie(other.rank, other.tet) < std::tie(rank, tet);
  }
};

bool touches_boundary(const WorkMesh& mesh, TetId t) {
  return std::any_of(mesh.tets[t].begin(), mesh.tets[t].end(),
                     [&](VertexId v) { return mesh.on_boundary(v); });
}

/// Whether t is below `goal`, or, where it does not touch the boundary, below what the interior is left at.
bool falls_short(const Workshop& shop, TetId t, double goal) {
  const double quality = shop.mesh.quality[t];
  return quality < goal &&
         (touches_boundary(shop.mesh, t) || quality < shape_of_angle(shop.options.leave_interior));
}

/// Removes the edge whose removal leaves the best shapes.
bool remove_best_edge(Workshop& shop, TetId t) {
  const auto v = shop.mesh.tets[t];
  double best = better_than(shop.mesh.quality[t]);
  int edge = -1;
  for (int e = 0; e < 6; ++e) {
    const double value = edge_removal_shape(shop, t, v[kTetEdge[e][0]], v[kTetEdge[e][1]], best);
    if (value > best) {
      best = value;
      edge = e;
    }
  }
  return edge >= 0 &&
         remove_edge(shop, t, v[kTetEdge[edge][0]], v[kTetEdge[edge][1]], better_than(shop.mesh.quality[t]));
}

bool swap_some_face(Workshop& shop, TetId t) {
  for (int f = 0; f < 4; ++f) {
    if (swap_face(shop, t, f, better_than(shop.mesh.quality[t]))) return true;
  }
  return false;
}

/// Smooths the vertex unless that was tried in vain and nothing has changed at it since: where elements
/// cannot get good, each vertex is a corner of several that are tried.
bool smooth_unless_vain(Workshop& shop, VertexId v, double goal) {
  shop.still.resize(shop.mesh.points.size(), 0);
  std::uint32_t& when = shop.still[v.index()];
  if (when > 0 && shop.unchanged_since(when, v)) return false;
  if (smooth_vertex(shop, v, goal)) return true;
  when = ++shop.serial;
  return false;
}

bool smooth_corners(Workshop& shop, TetId t, double goal) {
  bool any = false;
  std::vector<TetId> changed;
  for (const VertexId v : std::array(shop.mesh.tets[t])) {
    // Within a trial, and once a corner has moved, what has changed is not marked yet.
    const bool unmarked = any || shop.mesh.journal.open;
    if (unmarked ? !smooth_vertex(shop, v, goal) : !smooth_unless_vain(shop, v, goal)) continue;
    any = true;
    changed.insert(changed.end(), shop.made.begin(), shop.made.end());
    if (shop.mesh.quality[t] >= goal) break;
  }
  sort_unique(changed);
  if (any) shop.made = changed;
  return any;
}

/// The edges of t with their squared lengths, shortest first.
std::array<std::pair<double, int>, 6> edges_by_length(const WorkMesh& mesh, TetId t) {
  std::array<std::pair<double, int>, 6> edges;
  for (int e = 0; e < 6; ++e) {
    edges[e] = {(mesh.point(t, kTetEdge[e][0]) - mesh.point(t, kTetEdge[e][1])).squaredNorm(), e};
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool collapse_some_edge(Workshop& shop, TetId t) {
  const auto v = shop.mesh.tets[t];
  const double floor = better_than(shop.mesh.quality[t]);
  for (const auto& [length, e] : edges_by_length(shop.mesh, t)) {
    const VertexId a = v[kTetEdge[e][0]], b = v[kTetEdge[e][1]];
    if (collapse_edge(shop, a, b, floor) || collapse_edge(shop, b, a, floor)) return true;
  }
  return false;
}

bool split_some_edge(Workshop& shop, TetId t) {
  const auto v = shop.mesh.tets[t];
  const auto edges = edges_by_length(shop.mesh, t);
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) {
    const int e = edge->second;
    const double floor = better_than(shop.mesh.quality[t]);
    if (split_edge(shop, t, v[kTetEdge[e][0]], v[kTetEdge[e][1]], floor, 2.0 * floor)) return true;
  }
  return false;
}

bool budget_spent(Workshop& shop) {
  // Measured: an ordinary part uses a tenth of it at most; a thin shell, where nothing can be won, all of it.
  const std::uint64_t budget = 20'000'000 + 600 * static_cast<std::uint64_t>(shop.mesh.tets.size());
  if (shop.work > budget) shop.report.budget_spent = true;
  if (shop.options.max_seconds > 0.0) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - shop.started;
    if (spent.count() > shop.options.max_seconds) shop.report.budget_spent = true;
  }
  return shop.report.budget_spent;
}

void note_failure(Workshop& shop, TetId t) {
  shop.tried.resize(shop.mesh.tets.size(), 0);
  shop.tried[t.index()] = ++shop.serial;
}

/// Whether t was tried in vain and nothing has changed at its vertices since.
bool is_hopeless(const Workshop& shop, TetId t) {
  if (t.index() >= shop.tried.size()) return false;
  const std::uint32_t when = shop.tried[t.index()];
  const auto& v = shop.mesh.tets[t];
  return when > 0 &&
         std::all_of(v.begin(), v.end(), [&](VertexId x) { return shop.unchanged_since(when, x); });
}

/// Edges of the boundary's neighbourhood for which rank(a, b, length), a < b, has a value; lowest first.
template <class Rank>
std::vector<std::tuple<double, VertexId, VertexId>> boundary_edges(const WorkMesh& mesh, const Rank& rank) {
  std::vector<std::tuple<double, VertexId, VertexId>> edges;
  // The tetrahedra at an edge lie near each other in memory, so that this spares most of the four or five
  // times that an edge is met again.
  constexpr int kSlotBits = 12;
  EdgeSlots<bool> met(kSlotBits);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || !touches_boundary(mesh, t)) continue;
    for (const auto& e : kTetEdge) {
      const VertexId a = std::min(mesh.tets[t][e[0]], mesh.tets[t][e[1]]);
      const VertexId b = std::max(mesh.tets[t][e[0]], mesh.tets[t][e[1]]);
      if (met.find(a, b) != nullptr) continue;
      met.set(a, b, true);
      const std::optional<double> value = rank(a, b, (mesh.points[a] - mesh.points[b]).norm());
      if (value) edges.emplace_back(*value, a, b);
    }
  }
  sort_unique(edges);
  return edges;
}

/// The shape that a collapse of a short edge at `v` must keep: what is there, or what is good enough.
double collapse_floor(Workshop& shop, VertexId a, std::vector<TetId>& tets) {
  star(shop.mesh, a, tets);
  const double target = shape_of_angle(shop.options.target_dihedral);
  const double before = worst_quality(shop.mesh, tets);
  return before >= kCollapseShape ? std::min(before * 0.999, target) : better_than(before);
}

/// Takes the tetrahedra for which rank(t) has a value, lowest first, and the ones that come of them.
template <class Rank>
PassResult improve_in_order(Workshop& shop, double goal, Observer& observer, const Rank& rank) {
  const WorkMesh& mesh = shop.mesh;
  std::priority_queue<Candidate> queue;
  const auto look_at = [&](TetId t) {
    if (!mesh.alive(t)) return;
    if (const std::optional<double> value = rank(t)) queue.push({*value, t});
  };
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) look_at(TetId(i));
  PassResult result;
  while (!queue.empty() && !budget_spent(shop)) {
    const Candidate candidate = queue.top();
    queue.pop();
    if (!mesh.alive(candidate.tet) || rank(candidate.tet) != candidate.rank) continue;
    if (is_hopeless(shop, candidate.tet)) continue;
    if (result.tried++ % 64 == 0 && observer.cancelled()) throw Cancelled();
    if (!improve_tet(shop, candidate.tet, goal, Effort::kFull)) {
      note_failure(shop, candidate.tet);
      continue;
    }
    ++result.bettered;
    shop.note_change();
    for (const TetId t : shop.made) look_at(t);
  }
  return result;
}

}  // namespace

bool improve_tet(Workshop& shop, TetId t, double goal, Effort effort) {
  if (remove_best_edge(shop, t) || swap_some_face(shop, t) || smooth_corners(shop, t, goal)) return true;
  return effort == Effort::kFull &&
         (collapse_some_edge(shop, t) || split_some_edge(shop, t) || improve_by_compound(shop, t, goal));
}

void collapse_short_edges(Workshop& shop) {
  WorkMesh& mesh = shop.mesh;
  std::vector<double> size(mesh.points.size(), 0.0);
  const auto size_of = [&](VertexId v) {
    double& h = size[v.index()];
    if (h == 0.0) h = shop.size_at(mesh.points[v]);
    return h;
  };
  const auto edges = boundary_edges(mesh, [&](VertexId v, VertexId w, double length) {
    const double share = length / std::min(size_of(v), size_of(w));
    return share < shop.options.short_edge ? std::optional(share) : std::nullopt;
  });
  std::vector<TetId> tets;
  for (const auto& [share, a, b] : edges) {
    if (!mesh.alive(a) || !mesh.alive(b)) continue;
    if (mesh.on[a].dim >= mesh.on[b].dim && collapse_edge(shop, a, b, collapse_floor(shop, a, tets)))
      continue;
    if (mesh.on[b].dim >= mesh.on[a].dim) collapse_edge(shop, b, a, collapse_floor(shop, b, tets));
  }
  shop.forget_failures();
}

void split_long_edges(Workshop& shop, double goal) {
  const FlatWatch watch(shop.flats);
  WorkMesh& mesh = shop.mesh;
  const auto edges = boundary_edges(mesh, [&](VertexId v, VertexId w, double length) {
    const double share = length / shop.size_at(0.5 * (mesh.points[v] + mesh.points[w]));
    return share > shop.options.long_edge ? std::optional(-share) : std::nullopt;
  });
  EdgeRing ring;
  for (const auto& [share, a, b] : edges) {
    const TetId t = tet_with_edge(mesh, a, b);
    if (!t.valid()) continue;
    edge_ring(mesh, t, a, b, ring);
    split_edge(shop, t, a, b, std::min(0.999 * worst_quality(mesh, ring.tets), goal), goal);
  }
  shop.forget_failures();
}

void relax_around(Workshop& shop, double goal, double wish) {
  WorkMesh& mesh = shop.mesh;
  enum : std::uint8_t { kFar, kNear, kCorner };
  std::vector<std::uint8_t> role(mesh.points.size(), kFar);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || !falls_short(shop, t, goal)) continue;
    for (const VertexId v : mesh.tets[t]) role[v.index()] = kCorner;
  }
  std::vector<TetId> tets;
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] != kCorner) continue;
    star(mesh, VertexId(i), tets);
    for (const TetId s : tets)
      for (const VertexId v : mesh.tets[s]) role[v.index()] = std::max<std::uint8_t>(role[v.index()], kNear);
  }
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] == kFar) continue;
    if (budget_spent(shop)) return;
    if (smooth_unless_vain(shop, VertexId(i), wish)) shop.note_change();
  }
}

PassResult improve_worst_first(Workshop& shop, double goal, Observer& observer) {
  return improve_in_order(shop, goal, observer, [&](TetId t) {
    return falls_short(shop, t, goal) ? std::optional(shop.mesh.quality[t]) : std::nullopt;
  });
}

PassResult improve_obtuse(Workshop& shop, double limit, Observer& observer) {
  const WorkMesh& mesh = shop.mesh;
  const double goal = shape_of_angle(limit), of_limit = squared_cotangent(limit);
  return improve_in_order(shop, goal, observer, [&](TetId t) -> std::optional<double> {
    // The shape is no more than the squared sine of any of the angles.
    if (mesh.quality[t] >= goal || !touches_boundary(mesh, t)) return std::nullopt;
    const double largest =
        dihedral_cotangents(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3)).largest;
    return largest < of_limit ? std::optional(largest) : std::nullopt;
  });
}

}  // namespace octet
