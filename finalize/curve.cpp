// SPDX-License-Identifier: BSD-3-Clause
// Nodes go to the CAD first, and back where they must; each pass looks at what the one before it has moved.
#include "finalize/curve.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/blocks.h"
#include "base/error.h"
#include "base/sort_unique.h"
#include "mesh/edges.h"
#include "mesh/mid_nodes.h"
#include "mesh/quadratic.h"

namespace octet {
namespace {

using Index = Mesh::Index;

/// Of the chord: a node farther from its middle than this stays there (that of half a circle is at 0.5).
constexpr double kMostSag = 0.35;
/// Of the chord: what is nearer to its middle is as good as straight.
constexpr double kLeastSag = 1e-9;
/// Of the chord: an arc longer than this is not the one between its ends (half a circle has 1.57).
constexpr double kLongestArc = 1.5;
/// How often a node goes half of its way back before it goes all of it.
constexpr int kHalvings = 3;
constexpr std::size_t kQueries = 256;  ///< of the CAD, a task

/// The parameter of a vertex of the mesh on a model edge, as its first or as its last end.
double parameter_at(const Mesh& mesh, const Model& model, int edge, Index v, bool first) {
  const ModelEdge& on = model.edge(edge);
  const ModelRef ref = mesh.point_on[v];
  if (ref.dim == 0 && on.vertex[first ? 0 : 1] == ref.tag) return first ? on.t0 : on.t1;
  if (ref.dim == 0 && on.vertex[first ? 1 : 0] == ref.tag) return first ? on.t1 : on.t0;
  return model.edge_closest(edge, mesh.points[v]).t;
}

Vec3 middle_on_edge(const Mesh& mesh, const Model& model, int edge, const std::array<Index, 2>& ends) {
  const Vec3 &a = mesh.points[ends[0]], &b = mesh.points[ends[1]];
  const double from = parameter_at(mesh, model, edge, ends[0], true);
  const double to = parameter_at(mesh, model, edge, ends[1], false);
  const double length = model.edge_length(edge, from, to);
  if (std::abs(length) <= kLongestArc * (b - a).norm())
    return model.edge_point(edge, model.edge_parameter(edge, from, 0.5 * length));
  return model.edge_closest(edge, 0.5 * (a + b)).point;
}

/// Where nodes would best be, as ways from the middles of their chords.
class Wishes {
 public:
  Wishes(const Mesh& mesh, const Model& model) : mesh_(mesh), model_(model), way_(mesh.mid.points.size()) {
    ask();
  }
  [[nodiscard]] const Vec3& way(Index m) const { return way_[m]; }
  [[nodiscard]] bool curved(Index m) const { return !way_[m].isZero(0.0); }
  /// Whether an edge between such ends cannot follow the CAD.
  [[nodiscard]] bool too_far(Index m) const { return way_[m].norm() > kMostSag * chord(m); }

 private:
  [[nodiscard]] double chord(Index m) const {
    const EdgeEnds& ends = mesh_.mid.between[m];
    return (mesh_.points[ends[1]] - mesh_.points[ends[0]]).norm();
  }
  void ask() {
    const MidNodes& mid = mesh_.mid;
    std::fill(way_.begin(), way_.end(), Vec3::Zero());
    tbb::parallel_for(std::size_t{0}, mesh_.edges.size(), [&](std::size_t e) {
      const Index m = mid.of_edges[e];
      wish(m, middle_on_edge(mesh_, model_, mesh_.edge_on[e], mesh_.edges[e]));
    });
    const auto asked = collect<Index>(mid.points.size(), [&](std::size_t m, std::vector<Index>& list) {
      if (mid.on[m].dim == 2 && !model_.is_plane(mid.on[m].tag)) list.push_back(static_cast<Index>(m));
    });
    const tbb::blocked_range<std::size_t> all(0, asked.size(), kQueries);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const int face = mid.on[asked[i]].tag;
        const Vec3& middle = mid.points[asked[i]];
        const FaceFoot foot = model_.face_project(face, middle);
        wish(asked[i], foot.converged ? foot.point : model_.face_closest(face, middle).point);
      }
    });
  }
  void wish(Index m, const Vec3& place) {
    const Vec3 way = place - mesh_.mid.points[m];
    if (way.norm() > std::max(kLeastSag * chord(m), model_.tolerance())) way_[m] = way;
  }

  const Mesh& mesh_;
  const Model& model_;
  std::vector<Vec3> way_;
};

/// How far each node goes its way.
class Curving {
 public:
  Curving(Mesh& mesh, const Wishes& wishes) : mesh_(mesh), wishes_(wishes), back_(mesh.mid.points.size(), 0) {
    for (Index m = 0; m < back_.size(); ++m) {
      if (wishes_.too_far(m)) back_[m] = kHalvings + 1;
      mesh_.mid.points[m] = place(m, back_[m]);
    }
  }

  /// Tetrahedra with a curved edge.
  [[nodiscard]] std::vector<Index> curved_tets() const {
    return collect<Index>(mesh_.tets.size(), [&](std::size_t t, std::vector<Index>& list) {
      if (has(static_cast<Index>(t), [&](Index m) { return wishes_.curved(m); }))
        list.push_back(static_cast<Index>(t));
    });
  }
  /// Those of `tets` that are not as good as they should be.
  [[nodiscard]] std::vector<Index> bad_of(const std::vector<Index>& tets) const {
    return collect<Index>(
        tets.size(),
        [&](std::size_t i, std::vector<Index>& bad) {
          if (scaled_jacobian(jacobian_form(quadratic_tet(mesh_, tets[i]))) < kLeastScaledJacobian)
            bad.push_back(tets[i]);
        },
        kQueries);
  }
  /// One node of each tetrahedron goes back; returns which nodes, ascending.
  std::vector<Index> send_back(const std::vector<Index>& tets) {
    std::vector<Index> nodes = collect<Index>(
        tets.size(),
        [&](std::size_t i, std::vector<Index>& list) {
          if (const std::optional<Index> worst = most_in_the_way(tets[i])) list.push_back(*worst);
        },
        kQueries);
    sort_unique(nodes);
    for (const Index m : nodes) mesh_.mid.points[m] = place(m, ++back_[m]);
    return nodes;
  }
  /// Those of `tets` that have any of these nodes.
  [[nodiscard]] std::vector<Index> tets_at(const std::vector<Index>& nodes,
                                           const std::vector<Index>& tets) const {
    std::vector<std::uint8_t> flagged(back_.size(), 0);
    for (const Index m : nodes) flagged[m] = 1;
    return collect<Index>(tets.size(), [&](std::size_t i, std::vector<Index>& list) {
      if (has(tets[i], [&](Index m) { return flagged[m] != 0; })) list.push_back(tets[i]);
    });
  }
  /// Whether the node has gone all its way back.
  [[nodiscard]] bool straight(Index m) const { return back_[m] > kHalvings; }
  /// From where it would best be.
  [[nodiscard]] double distance_back(Index m) const {
    return (1.0 - share_of_way(back_[m])) * wishes_.way(m).norm();
  }

 private:
  /// After going back so often.
  static double share_of_way(int back) { return back > kHalvings ? 0.0 : std::ldexp(1.0, -back); }
  [[nodiscard]] Vec3 place(Index m, int back) const {
    const Vec3 middle = middle_of(mesh_, mesh_.mid.between[m]);
    return back > kHalvings ? middle : Vec3(middle + share_of_way(back) * wishes_.way(m));
  }
  [[nodiscard]] bool can_go_back(Index m) const { return wishes_.curved(m) && back_[m] <= kHalvings; }

  /// The node that helps most by going back; none where all edges are straight.
  [[nodiscard]] std::optional<Index> most_in_the_way(Index t) const {
    std::optional<Index> worst;
    double best = 0.0;
    const QuadraticTet nodes = quadratic_tet(mesh_, t);
    for (std::size_t e = 0; e < 6; ++e) {
      const Index m = mesh_.mid.of_tets[t][e];
      if (!can_go_back(m)) continue;
      QuadraticTet moved = nodes;
      moved[4 + e] = place(m, back_[m] + 1);
      const double quality = scaled_jacobian(jacobian_form(moved));
      if (worst && quality <= best) continue;
      worst = m;
      best = quality;
    }
    return worst;
  }
  template <class Wanted>
  [[nodiscard]] bool has(Index t, const Wanted& wanted) const {
    const auto& mid = mesh_.mid.of_tets[t];
    return std::any_of(mid.begin(), mid.end(), wanted);
  }

  Mesh& mesh_;
  const Wishes& wishes_;
  std::vector<std::uint8_t> back_;  ///< how often each node has gone back
};

/// The farther one; the first of two as far.
void keep_farther(std::optional<OffCad>& farthest, const OffCad& place) {
  if (!farthest || place.distance > farthest->distance) farthest = place;
}

/// The farthest of the places that look(i, farthest) compares, i < n.
template <class Look>
std::optional<OffCad> farthest_of(std::size_t n, const Look& look) {
  std::optional<OffCad> farthest;
  for (const auto& of_block :
       map_blocks<std::optional<OffCad>>(n, kQueries, [&](std::size_t first, std::size_t last) {
         std::optional<OffCad> own;
         for (std::size_t i = first; i < last; ++i) look(i, own);
         return own;
       }))
    if (of_block) keep_farther(farthest, *of_block);
  return farthest;
}

Vec3 centre_of_triangle(const Mesh& mesh, std::size_t t) {
  Vec3 centre = Vec3::Zero();
  for (const Index v : mesh.triangles[t]) centre -= mesh.points[v] / 9.0;
  for (const Index m : mesh.mid.of_triangles[t]) centre += mesh.mid.points[m] * (4.0 / 9.0);
  return centre;
}

std::optional<OffCad> farthest_from_faces(const Mesh& mesh, const Model& model) {
  return farthest_of(mesh.triangles.size(), [&](std::size_t t, std::optional<OffCad>& farthest) {
    const int face = mesh.triangle_on[t];
    if (model.is_plane(face)) return;
    const Vec3 place = centre_of_triangle(mesh, t);
    const FaceFoot foot = model.face_project(face, place);
    if (foot.converged) keep_farther(farthest, {model_face(face), place, (foot.point - place).norm()});
  });
}

std::optional<OffCad> farthest_from_edges(const Mesh& mesh, const Model& model) {
  return farthest_of(mesh.edges.size(), [&](std::size_t e, std::optional<OffCad>& farthest) {
    const int edge = mesh.edge_on[e];
    const Vec3& middle = mesh.mid.points[mesh.mid.of_edges[e]];
    for (const int near : {0, 1}) {
      const Vec3 &a = mesh.points[mesh.edges[e][near]], &b = mesh.points[mesh.edges[e][1 - near]];
      const Vec3 place = 0.375 * a + 0.75 * middle - 0.125 * b;
      keep_farther(farthest, {model_edge(edge), place, model.edge_closest(edge, place).distance});
    }
  });
}

double least_of(const Mesh& mesh, const std::vector<Index>& tets) {
  double least = 1.0;
  for (const double value :
       map_blocks<double>(tets.size(), kQueries, [&](std::size_t first, std::size_t last) {
         double own = 1.0;
         for (std::size_t i = first; i < last; ++i)
           own = std::min(own, scaled_jacobian(jacobian_form(quadratic_tet(mesh, tets[i]))));
         return own;
       }))
    least = std::min(least, value);
  return least;
}

CurveReport report_of(const Mesh& mesh, const Model& model, const Wishes& wishes, const Curving& curving,
                      const std::vector<Index>& curved_tets) {
  CurveReport report;
  for (Index m = 0; m < mesh.mid.points.size(); ++m) {
    if (!wishes.curved(m)) continue;
    if (!curving.straight(m)) ++report.curved;
    if (curving.distance_back(m) > 0.0)
      report.held.push_back({mesh.mid.on[m], mesh.mid.points[m], curving.distance_back(m)});
  }
  std::stable_sort(report.held.begin(), report.held.end(),
                   [](const OffCad& a, const OffCad& b) { return a.distance > b.distance; });
  if (!report.held.empty()) report.farthest = report.held.front();
  for (const auto& far : {farthest_from_faces(mesh, model), farthest_from_edges(mesh, model)})
    if (far && far->distance > model.tolerance()) keep_farther(report.farthest, *far);
  report.least_scaled_jacobian = least_of(mesh, curved_tets);
  return report;
}

}  // namespace

CurveReport curve_mesh(Mesh& mesh, const Model& model, Observer& observer) {
  mesh.mid = straight_mid_nodes(mesh);
  const Wishes wishes(mesh, model);
  Curving curving(mesh, wishes);
  const std::vector<Index> curved = curving.curved_tets();
  for (std::vector<Index> bad = curving.bad_of(curved); !bad.empty();) {
    if (observer.cancelled()) throw Cancelled();
    const std::vector<Index> moved = curving.send_back(bad);
    if (moved.empty()) break;  // nothing of theirs is curved any more: rounding of what is flat
    bad = curving.bad_of(curving.tets_at(moved, curved));
  }
  return report_of(mesh, model, wishes, curving, curved);
}

}  // namespace octet
