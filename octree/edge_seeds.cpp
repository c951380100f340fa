// SPDX-License-Identifier: BSD-3-Clause
// Points on model edges: equal shares of the local size, and partners on edges that run close by.
#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "geom/edge_turn.h"
#include "octree/equal_parts.h"
#include "octree/seed_state.h"

namespace octet {
namespace {

/// Points closer than this share of the local size to a point of the same edge are not worth a pair.
constexpr double kEdgeSpacing = 0.4;
constexpr double kPieceLength = 1.17;

/// Length of an edge in units of the local size, as a function of the parameter.
class SizedLength {
 public:
  SizedLength(const SeedState& state, int tag)
      : SizedLength(state, tag, state.model.edge(tag).t0, state.model.edge(tag).t1,
                    [&](const Vec3& p) { return state.tree.spacing_at(p); }) {}

  /// From t0 on to t1; `spacing_at`: the local size at a place between.
  template <class Spacing>
  SizedLength(const SeedState& state, int tag, double t0, double t1, const Spacing& spacing_at) {
    const double whole = state.model.edge_length(tag, t0, t1);
    double finest = whole;
    for (int i = 0; i <= 32; ++i)
      finest = std::min(finest, spacing_at(state.model.edge_point(tag, t0 + (t1 - t0) * i / 32)));
    const int n = static_cast<int>(std::clamp(std::ceil(4.0 * whole / finest), 16.0, 20000.0));
    Vec3 last = state.model.edge_point(tag, t0);
    t_.push_back(t0);
    s_.push_back(0.0);
    for (int i = 1; i <= n; ++i) {
      const double t = t0 + (t1 - t0) * i / n;
      const Vec3 p = state.model.edge_point(tag, t);
      s_.push_back(s_.back() + (p - last).norm() / spacing_at(0.5 * (p + last)));
      t_.push_back(t);
      last = p;
    }
  }
  [[nodiscard]] double at(double t) const { return interpolate(t_, s_, t); }
  [[nodiscard]] double parameter(double s) const { return interpolate(s_, t_, s); }

 private:
  static double interpolate(const std::vector<double>& x, const std::vector<double>& y, double value) {
    const auto hi = std::clamp<std::ptrdiff_t>(std::upper_bound(x.begin(), x.end(), value) - x.begin(), 1,
                                               static_cast<std::ptrdiff_t>(x.size()) - 1);
    const double w = x[hi] > x[hi - 1] ? (value - x[hi - 1]) / (x[hi] - x[hi - 1]) : 0.0;
    return y[hi - 1] + w * (y[hi] - y[hi - 1]);
  }
  std::vector<double> t_, s_;
};

class EdgeSeeder {
 public:
  EdgeSeeder(SeedState& state, const SeedOptions& options)
      : state_(state),
        model_(state.model),
        stops_(static_cast<std::size_t>(model_.count(1)) + 1),
        divided_(stops_.size(), false) {
    for (int e = 1; e < static_cast<int>(options.divisions.size()); ++e)
      if (options.divisions[e] > 0 && model_.edge(e).use == EdgeUse::kReal) divide(e, options.divisions[e]);
    if (options.periodic != nullptr) tie(*options.periodic);
  }

  void run() {
    match_pending();
    match_vertices();
    stop_at_rings();
    for (int e = 1; e <= model_.count(1); ++e) {
      if (model_.edge(e).use != EdgeUse::kReal) continue;
      subdivide(e);
      match_pending();
    }
    for (int e = 1; e <= model_.count(1); ++e)
      if (model_.edge(e).use == EdgeUse::kReal) stop_at_turns(e);
    for (int e = 1; e <= model_.count(1); ++e)
      if (model_.edge(e).use == EdgeUse::kReal) emit(e);
  }

 private:
  struct Stop {
    int edge;
    double t;
  };

  [[nodiscard]] double spacing_at(const Vec3& p) const { return state_.tree.spacing_at(p); }

  /// Puts a stop on the edge unless one is near; its own partners are sought later.
  void add_stop(int tag, double t, double spacing) {
    if (divided_[tag]) return;
    const ModelEdge& edge = model_.edge(tag);
    const Vec3 p = model_.edge_point(tag, t);
    const double clear = spacing * spacing_at(p);
    const auto near = [&](double other) { return (model_.edge_point(tag, other) - p).norm() < clear; };
    if (near(edge.t0) || near(edge.t1)) return;
    std::vector<double>& stops = stops_[tag];
    const auto at = std::lower_bound(stops.begin(), stops.end(), t);
    if (at != stops.end() && near(*at)) return;
    if (at != stops.begin() && near(*std::prev(at))) return;
    stops.insert(at, t);
    pending_.push_back({tag, t});
  }

  /// A vertex close to an edge that does not end in it gets its foot on that edge.
  void match_vertices() {
    for (int v = 1; v <= model_.count(0); ++v) {
      const Vec3 p = model_.vertex(v).point;
      for (const EdgePartner& foot : state_.edge_index.feet(p, kMatchDistance * spacing_at(p))) {
        const auto& ends = model_.edge(foot.edge).vertex;
        if (ends[0] != v && ends[1] != v) add_stop(foot.edge, foot.t, kEdgeSpacing);
      }
    }
    match_pending();
  }

  /// Edges along a sharp tip have a point of its ring: the first of them where it leaves the tip's ball, the
  /// others across from there, if they have a point that is about where they leave it.
  void stop_at_rings() {
    constexpr double kAbout = 0.1;
    for (const Tip& tip : state_.seeds.tips.all())
      for (const int e : model_.vertex(tip.vertex).edges) {
        if (model_.edge(e).use != EdgeUse::kReal) continue;
        const std::optional<double> t = ring_parameter(model_, tip, e);
        if (!t) continue;
        const Vec3 p = model_.edge_point(e, *t);
        const bool is_matched = std::any_of(stops_[e].begin(), stops_[e].end(), [&](double stop) {
          return (model_.edge_point(e, stop) - p).norm() < kAbout * tip.reach;
        });
        if (is_matched) continue;
        add_stop(e, *t, kEdgeSpacing);
        match_pending();
      }
  }

  void match_pending() {
    while (!pending_.empty()) {
      const Stop stop = pending_.front();
      pending_.pop_front();
      const double reach = kMatchDistance * spacing_at(model_.edge_point(stop.edge, stop.t));
      for (const EdgePartner& b : state_.edge_index.partners(stop.edge, stop.t, reach))
        add_stop(b.edge, b.t, kEdgeSpacing);
    }
  }

  /// Fewest pieces between two stops so that no two edges share both ends and a closed edge is a polygon.
  [[nodiscard]] int least_pieces(int tag, double ta, double tb) const {
    const ModelEdge& edge = model_.edge(tag);
    if (ta > edge.t0 || tb < edge.t1) return 1;
    if (edge.vertex[0] == edge.vertex[1]) return 4;
    const double chord = (model_.edge_point(tag, tb) - model_.edge_point(tag, ta)).norm();
    if (edge.length > 1.1 * chord) return 2;
    for (const int other : model_.vertex(edge.vertex[0]).edges) {
      const auto& ends = model_.edge(other).vertex;
      if (other != tag && model_.edge(other).use == EdgeUse::kReal &&
          (ends[0] == edge.vertex[1] || ends[1] == edge.vertex[1]))
        return 2;
    }
    return 1;
  }

  /// Whether a face that the edge bounds should have no point there.
  [[nodiscard]] bool is_in_tip(int tag, double t) const {
    const std::vector<int>& faces = model_.edge(tag).faces;
    return std::any_of(faces.begin(), faces.end(),
                       [&](int face) { return state_.seeds.tips.holder(face, model_.edge_point(tag, t)); });
  }

  /// In equal pieces, for the user's sake, unless they are far from the local size.
  void divide(int tag, int pieces) {
    constexpr double kShortest = 0.4, kLongest = 2.2;
    const ModelEdge& edge = model_.edge(tag);
    const double mean = SizedLength(state_, tag).at(edge.t1) / pieces;
    if (mean < kShortest || mean > kLongest) return;
    divided_[tag] = true;
    stops_[tag] = equal_parts(model_, tag, std::max(pieces, least_pieces(tag, edge.t0, edge.t1)));
    for (const double t : stops_[tag]) pending_.push_back({tag, t});
  }

  /// Edges that are images of one another have the same points: those given, or those in equal pieces that
  /// one of them has already, or else such as the least of the local sizes asks for.
  void tie(const PeriodicSeeds& seeds) {
    const Periodicity& periodicity = seeds.periodicity;
    std::vector<std::vector<double>> tied(stops_.size());
    for (const std::vector<PieceMember>& orbit : periodicity.pieces()) {
      const bool whole = periodicity.is_whole(orbit);
      const PieceMember* source = &orbit.front();
      for (const PieceMember& member : orbit)
        if (whole && stops_[member.edge].size() > stops_[source->edge].size()) source = &member;
      const std::vector<double> stops =
          whole && divided_[source->edge] ? stops_[source->edge] : stops_for(*source, orbit, whole);
      for (const PieceMember& member : orbit) {
        std::vector<double>& own = tied[member.edge];
        const Motion motion = member.motion.after(source->motion.inverse());
        for (const double t : stops)
          own.push_back(&member == source ? t : image_of(source->edge, t, motion, member.edge));
        if (member.t1 < model_.edge(member.edge).t1) own.push_back(member.t1);
      }
    }
    for (int e = 1; e <= model_.count(1); ++e) {
      if (!periodicity.holds(model_edge(e))) continue;
      stops_[e] = seeds.given.has_edge(e) ? *seeds.given.on_edge[static_cast<std::size_t>(e)] : tied[e];
      std::sort(stops_[e].begin(), stops_[e].end());
      divided_[e] = true;
      for (const double t : stops_[e]) pending_.push_back({e, t});
    }
  }

  /// Those between the ends of a piece, by the least of the sizes along its images.
  [[nodiscard]] std::vector<double> stops_for(const PieceMember& piece, const std::vector<PieceMember>& orbit,
                                              bool whole) const {
    const SizedLength length(state_, piece.edge, piece.t0, piece.t1, [&](const Vec3& p) {
      double least = spacing_at(p);
      for (const PieceMember& member : orbit)
        least = std::min(least, spacing_at(member.motion.after(piece.motion.inverse())(p)));
      return least;
    });
    int n = std::max(1, static_cast<int>(std::ceil(length.at(piece.t1) / kPieceLength - 0.5)));
    for (const PieceMember& member : orbit) {
      const Vec3 a = model_.edge_point(member.edge, member.t0), b = model_.edge_point(member.edge, member.t1);
      if (whole)
        n = std::max(n, least_pieces(member.edge, member.t0, member.t1));
      else if (model_.edge_length(member.edge, member.t0, member.t1) > 1.1 * (b - a).norm())
        n = std::max(n, 2);
    }
    std::vector<double> stops;
    for (int k = 1; k < n; ++k) stops.push_back(length.parameter(length.at(piece.t1) * k / n));
    return stops;
  }

  [[nodiscard]] double image_of(int edge, double t, const Motion& motion, int image) const {
    return model_.edge_closest(image, motion(model_.edge_point(edge, t))).t;
  }

  void subdivide(int tag) {
    if (divided_[tag]) return;
    const ModelEdge& edge = model_.edge(tag);
    const SizedLength length(state_, tag);
    std::vector<double> ends = stops_[tag];
    ends.insert(ends.begin(), edge.t0);
    ends.push_back(edge.t1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double sa = length.at(ends[i]), sb = length.at(ends[i + 1]);
      // A piece may be up to a quarter longer than the size: fewer, better pieces.
      const int least = least_pieces(tag, ends[i], ends[i + 1]);
      const int n = std::max(least, static_cast<int>(std::ceil((sb - sa) / kPieceLength - 0.5)));
      for (int k = 1; k < n; ++k) {
        const double t = length.parameter(sa + (sb - sa) * k / n);
        if (n > least && is_in_tip(tag, t)) continue;
        std::vector<double>& stops = stops_[tag];
        stops.insert(std::lower_bound(stops.begin(), stops.end(), t), t);
        pending_.push_back({tag, t});
      }
    }
  }

  /// Where an edge turns back within a piece, as at the end of a narrow groove, it has a point there.
  void stop_at_turns(int tag) {
    constexpr int kMost = 6;  // halves of halves
    for (int pass = 0; pass < kMost; ++pass) {
      std::vector<double> ends = stops_[tag];
      ends.insert(ends.begin(), model_.edge(tag).t0);
      ends.push_back(model_.edge(tag).t1);
      bool any = false;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (const std::optional<double> t = turn_between(tag, ends[i], ends[i + 1])) {
          std::vector<double>& stops = stops_[tag];
          stops.insert(std::lower_bound(stops.begin(), stops.end(), *t), *t);
          pending_.push_back({tag, *t});
          any = true;
        }
      if (!any) return;
      match_pending();
    }
  }

  /// Where the edge turns back between two points: the parameter of the point with the longest way to both.
  [[nodiscard]] std::optional<double> turn_between(int tag, double ta, double tb) const {
    const Vec3 pa = model_.edge_point(tag, ta), pb = model_.edge_point(tag, tb);
    if (!turns_back(model_, tag, {pa, ta}, {pb, tb})) return std::nullopt;
    const auto length = [&](double t) {
      const Vec3 p = model_.edge_point(tag, t);
      return (p - pa).norm() + (p - pb).norm();
    };
    constexpr int kSamples = 16, kRounds = 4;
    double lo = ta, hi = tb, best = 0.5 * (ta + tb);
    for (int round = 0; round < kRounds; ++round) {
      const double step = (hi - lo) / kSamples;
      for (int i = 0; i <= kSamples; ++i)
        if (const double t = lo + i * step; length(t) > length(best)) best = t;
      lo = std::max(ta, best - step);
      hi = std::min(tb, best + step);
    }
    return best > ta && best < tb ? std::optional(best) : std::nullopt;
  }

  void emit(int tag) {
    const ModelEdge& edge = model_.edge(tag);
    Seeds& seeds = state_.seeds;
    std::uint32_t last = seeds.model_vertex[edge.vertex[0]];
    double t_last = edge.t0;
    const auto is_tip = [&](std::uint32_t point) {
      const std::vector<Tip>& tips = seeds.tips.all();
      return std::any_of(tips.begin(), tips.end(),
                         [&](const Tip& tip) { return seeds.model_vertex[tip.vertex] == point; });
    };
    const auto piece = [&](std::uint32_t to, double t) {
      const Vec3 a = seeds.points.position[last], b = seeds.points.position[to];
      const auto number = static_cast<std::uint32_t>(seeds.pieces.size());
      seeds.pieces.push_back({last, to, t_last, t, tag});
      const Vec3 middle = 0.5 * (a + b);
      state_.piece_grid.add(number, middle, std::max((b - a).norm(), spacing_at(middle)));
      constexpr double kLong = 2.5;
      if ((is_tip(last) || is_tip(to)) &&
          (b - a).norm() > kLong * std::min({spacing_at(a), spacing_at(b), spacing_at(middle)}))
        state_.long_pieces.push_back(number);
      last = to;
      t_last = t;
    };
    for (const double t : stops_[tag]) {
      const Vec3 p = model_.edge_point(tag, t);
      piece(state_.add(p, model_edge(tag), spacing_at(p)), t);
    }
    piece(seeds.model_vertex[edge.vertex[1]], edge.t1);
  }

  SeedState& state_;
  const Model& model_;
  std::vector<std::vector<double>> stops_;  ///< interior parameters per edge, ascending
  std::vector<bool> divided_;               ///< per edge: its stops are all that it has
  std::deque<Stop> pending_;
};

}  // namespace

void seed_model_edges(SeedState& state, const SeedOptions& options) { EdgeSeeder(state, options).run(); }

}  // namespace octet
