// SPDX-License-Identifier: BSD-3-Clause
// Loops to triangles: holes are joined to their outer loop by bridges, then ears are cut off.
//
// Loops that cross or touch cannot be triangulated well, but they can be triangulated: when no ear is left,
// the corner that turns least the wrong way is cut off all the same. What is lost is shape, never a border
// side.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "geom/planar_triangulation.h"

namespace octet {
namespace {

using Loop = std::vector<std::uint32_t>;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double area_of(const std::vector<Vec2>& points, const Loop& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 origin = points[loop[0]];
    twice += cross(points[loop[i]] - origin, points[loop[(i + 1) % loop.size()]] - origin);
  }
  return 0.5 * twice;
}

bool contains(const std::vector<Vec2>& points, const Loop& loop, const Vec2& p) {
  bool in = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if ((orient2d(a, b, p) > 0) == (b.y() > a.y())) in = !in;
  }
  return in;
}

/// Whether the open segments pq and ab cross, or one passes through an end of the other.
bool cross_or_touch(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  if (std::max(p.x(), q.x()) < std::min(a.x(), b.x()) || std::max(a.x(), b.x()) < std::min(p.x(), q.x()) ||
      std::max(p.y(), q.y()) < std::min(a.y(), b.y()) || std::max(a.y(), b.y()) < std::min(p.y(), q.y()))
    return false;
  const int sa = orient2d(p, q, a), sb = orient2d(p, q, b);
  if (sa * sb > 0) return false;
  const int sp = orient2d(a, b, p), sq = orient2d(a, b, q);
  return sp * sq <= 0;
}

/// A corner of the polygon that is left. `owner` and `side`: the triangle behind the side to the next corner;
/// `bridge` 0, or the number that the two sides of a bridge share.
struct Corner {
  std::uint32_t point = 0;
  bool convex = true, gone = false;
  std::int32_t previous = 0, next = 0;
  std::int32_t owner = PlanarTriangulation::kNone;
  int side = 0;
  int bridge = 0;
};

/// Numbered points in the squares of a grid.
class Buckets {
 public:
  Buckets() = default;
  explicit Buckets(const std::vector<std::pair<Vec2, std::int32_t>>& points) {
    Vec2 hi = points.front().first;
    lo_ = hi;
    for (const auto& [p, id] : points) {
      lo_ = lo_.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(points.size()))), 1, 1000);
    for (int axis = 0; axis < 2; ++axis)
      per_length_[axis] = hi[axis] > lo_[axis] ? side_ / (hi[axis] - lo_[axis]) : 0.0;
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (const auto& [p, id] : points) cell(index(p, 0), index(p, 1)).push_back(id);
  }

  /// Whether `test` holds for a point in a square that meets the box.
  template <class Test>
  [[nodiscard]] bool any(const Vec2& lo, const Vec2& hi, const Test& test) const {
    const int x1 = index(hi, 0), y1 = index(hi, 1);
    for (int y = index(lo, 1); y <= y1; ++y)
      for (int x = index(lo, 0); x <= x1; ++x)
        for (const std::int32_t id : cells_[position(x, y)])
          if (test(id)) return true;
    return false;
  }

 private:
  [[nodiscard]] int index(const Vec2& p, int axis) const {
    return std::clamp(static_cast<int>((p[axis] - lo_[axis]) * per_length_[axis]), 0, side_ - 1);
  }
  [[nodiscard]] std::size_t position(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  std::vector<std::int32_t>& cell(int x, int y) { return cells_[position(x, y)]; }

  Vec2 lo_ = Vec2::Zero(), per_length_ = Vec2::Zero();
  int side_ = 1;
  std::vector<std::vector<std::int32_t>> cells_;
};

class Clipper {
 public:
  explicit Clipper(PlanarTriangulation& result) : result_(result), points_(result.points) {}

  void run(const Loop& outer, std::vector<const Loop*> holes) {
    all_loops_ = {&outer};
    all_loops_.insert(all_loops_.end(), holes.begin(), holes.end());
    find_touches();
    first_ = append(outer);
    count_ = static_cast<int>(outer.size());
    const auto right = [&](const Loop* loop) {
      double x = -std::numeric_limits<double>::infinity();
      for (const std::uint32_t i : *loop) x = std::max(x, points_[i].x());
      return x;
    };
    // From right to left: what lies to the right of a hole is joined already, so a bridge can be found.
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const Loop* a, const Loop* b) { return right(a) > right(b); });
    for (const Loop* hole : holes) join(*hole);
    clip();
  }

 private:
  std::int32_t append(const Loop& loop) {
    const auto start = static_cast<std::int32_t>(ring_.size());
    const auto n = static_cast<std::int32_t>(loop.size());
    for (std::int32_t i = 0; i < n; ++i) {
      Corner corner;
      corner.point = loop[static_cast<std::size_t>(i)];
      corner.previous = start + (i + n - 1) % n;
      corner.next = start + (i + 1) % n;
      ring_.push_back(corner);
    }
    return start;
  }

  const Vec2& at(std::int32_t c) const { return points_[ring_[c].point]; }

  /// Whether the direction from corner c to p points into the polygon.
  bool opens_to(std::int32_t c, const Vec2& p) const {
    const Vec2 &a = at(ring_[c].previous), &o = at(c), &b = at(ring_[c].next);
    const int left_of_in = orient2d(a, o, p), left_of_out = orient2d(o, b, p);
    return orient2d(a, o, b) > 0 ? left_of_in > 0 && left_of_out > 0 : left_of_in > 0 || left_of_out > 0;
  }

  bool sees(const Vec2& p, const Vec2& q) const {
    for (const Loop* loop : all_loops_)
      for (std::size_t i = 0; i < loop->size(); ++i) {
        const Vec2 &a = points_[(*loop)[i]], &b = points_[(*loop)[(i + 1) % loop->size()]];
        if (a == p || a == q || b == p || b == q) continue;
        if (cross_or_touch(p, q, a, b)) return false;
      }
    // A bridge may be nearer than what was the nearest corner before its hole was joined.
    return std::none_of(bridge_ends_.begin(), bridge_ends_.end(), [&](const std::array<Vec2, 2>& bridge) {
      const auto& [a, b] = bridge;
      return a != p && a != q && b != p && b != q && cross_or_touch(p, q, a, b);
    });
  }

  /// The places that several corners have, of one loop or of two.
  void find_touches() {
    std::vector<std::pair<double, double>> places;
    for (const Loop* loop : all_loops_)
      for (const std::uint32_t i : *loop) places.emplace_back(points_[i].x(), points_[i].y());
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      if (places[i] == places[i + 1] && (touches_.empty() || touches_.back() != places[i]))
        touches_.push_back(places[i]);
  }

  bool touches(std::int32_t c) const {
    return std::binary_search(touches_.begin(), touches_.end(), std::pair(at(c).x(), at(c).y()));
  }

  /// Where the hole touches the polygon in a corner, that is its bridge: the two flat triangles beside it
  /// leave a polygon that does not touch itself there.
  bool join_where_it_touches(std::int32_t start, const std::vector<std::int32_t>& polygon) {
    if (touches_.empty()) return false;
    for (auto from = start; from < static_cast<std::int32_t>(ring_.size()); ++from) {
      if (!touches(from)) continue;
      for (const std::int32_t to : polygon) {
        if (at(to) != at(from) || !opens_to(to, at(ring_[from].previous)) ||
            !opens_to(to, at(ring_[from].next)))
          continue;
        const std::int32_t to_copy = splice(to, from);
        cut(to);
        cut(to_copy);
        return true;
      }
    }
    return false;
  }

  /// A bridge from the hole's rightmost corner to the nearest corner of the polygon that it sees; where it
  /// sees none, since loops cross, to the nearest.
  void join(const Loop& hole) {
    const std::int32_t start = append(hole);
    std::vector<std::int32_t> order;
    for (std::int32_t c = first_, i = 0; i < count_; ++i, c = ring_[c].next) order.push_back(c);
    count_ += static_cast<int>(hole.size()) + 2;
    if (join_where_it_touches(start, order)) return;
    std::int32_t from = start;
    for (auto c = start; c < static_cast<std::int32_t>(ring_.size()); ++c)
      if (at(c).x() > at(from).x()) from = c;
    // Nearest first, of equally near ones as they follow one another; most often one of the first will do.
    std::vector<std::pair<double, std::int32_t>> near;
    for (std::size_t i = 0; i < order.size(); ++i)
      near.emplace_back((at(order[i]) - at(from)).squaredNorm(), static_cast<std::int32_t>(i));
    std::make_heap(near.begin(), near.end(), std::greater<>());
    std::int32_t to = order[static_cast<std::size_t>(near.front().second)];
    for (auto end = near.end(); end != near.begin(); --end) {
      std::pop_heap(near.begin(), end, std::greater<>());
      const std::int32_t c = order[static_cast<std::size_t>((end - 1)->second)];
      if (at(c) == at(from) || !opens_to(c, at(from)) || !opens_to(from, at(c)) || !sees(at(from), at(c)))
        continue;
      to = c;
      break;
    }
    splice(to, from);
  }

  /// ... to -> from ... (round the hole) ... from' -> to' ...; returns to'.
  std::int32_t splice(std::int32_t to, std::int32_t from) {
    const auto to_copy = static_cast<std::int32_t>(ring_.size()), from_copy = to_copy + 1;
    ring_.push_back(ring_[to]);
    ring_.push_back(ring_[from]);
    ring_[ring_[to].next].previous = to_copy;
    ring_[ring_[from].previous].next = from_copy;
    ring_[to].next = from;
    ring_[from_copy].previous = ring_[from].previous;
    ring_[from].previous = to;
    ring_[from_copy].next = to_copy;
    ring_[to_copy].previous = from_copy;
    ++bridges_;
    bridge_ends_.push_back({at(to), at(from)});
    ring_[to].bridge = ring_[from_copy].bridge = bridges_;
    ring_[to].owner = ring_[from_copy].owner = PlanarTriangulation::kNone;
    return to_copy;
  }

  void update_convexity(std::int32_t c) {
    ring_[c].convex = orient2d(at(ring_[c].previous), at(c), at(ring_[c].next)) > 0;
  }

  bool cuttable(std::int32_t c) const { return ring_[ring_[c].previous].point != ring_[ring_[c].next].point; }

  bool is_ear(std::int32_t c) const {
    if (!ring_[c].convex || !cuttable(c)) return false;
    const std::array<std::int32_t, 3> ear{ring_[c].previous, c, ring_[c].next};
    const Vec2 &a = at(ear[0]), &b = at(ear[1]), &d = at(ear[2]);
    const auto blocks = [&](std::int32_t k) {
      const Corner& corner = ring_[k];
      if (corner.gone) return false;
      const Vec2& p = points_[corner.point];
      if (p == a || p == b || p == d) return goes_into(ear, k);
      if (corner.convex) return false;
      return orient2d(a, b, p) >= 0 && orient2d(b, d, p) >= 0 && orient2d(d, a, p) >= 0;
    };
    return !buckets_.any(a.cwiseMin(b).cwiseMin(d), a.cwiseMax(b).cwiseMax(d), blocks);
  }

  /// Whether a side at k, which lies on a corner of the ear, goes into the ear: loops touch there.
  bool goes_into(const std::array<std::int32_t, 3>& ear, std::int32_t k) const {
    for (int i = 0; i < 3; ++i) {
      const Vec2 &before = at(ear[(i + 2) % 3]), &corner = at(ear[i]), &after = at(ear[(i + 1) % 3]);
      if (ear[i] == k || at(k) != corner) continue;
      for (const std::int32_t end : {ring_[k].previous, ring_[k].next})
        if (orient2d(before, corner, at(end)) > 0 && orient2d(corner, after, at(end)) > 0) return true;
    }
    return false;
  }

  /// Corners are looked at in turn, those beside a cut again; when all were and none is an ear, one is cut
  /// all the same.
  void clip() {
    std::vector<std::pair<Vec2, std::int32_t>> corners;
    std::deque<std::int32_t> turn;
    for (std::int32_t c = first_, i = 0; i < count_; ++i, c = ring_[c].next) {
      update_convexity(c);
      corners.emplace_back(at(c), c);
      turn.push_back(c);
    }
    buckets_ = Buckets(corners);
    bool cut_any = false;
    while (count_ > 3) {
      if (turn.empty()) {
        if (!cut_any && !cut_least_bad()) return give_up();
        cut_any = false;
        for (std::int32_t c = first_, i = 0; i < count_; ++i, c = ring_[c].next) turn.push_back(c);
      }
      const std::int32_t c = turn.front();
      turn.pop_front();
      if (ring_[c].gone || !is_ear(c)) continue;
      const std::int32_t before = cut(c);
      cut_any = true;
      turn.push_back(before);
      turn.push_back(ring_[before].next);
    }
    if (!cuttable(first_) || !cuttable(ring_[first_].next)) return give_up();
    close(first_);
  }

  bool cut_least_bad() {
    if (count_ <= 3) return true;
    const std::int32_t c = least_bad(first_);
    if (!cuttable(c)) return false;
    cut(c);
    return true;
  }

  void give_up() { result_.triangles.clear(); }

  /// The corner whose triangle is the least turned, for its size.
  std::int32_t least_bad(std::int32_t start) const {
    std::int32_t best = start, c = start;
    double best_height = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < count_; ++i, c = ring_[c].next) {
      if (!cuttable(c)) continue;
      const Vec2 &a = at(ring_[c].previous), &b = at(c), &d = at(ring_[c].next);
      const double base = (d - a).norm();
      const double height = base > 0.0 ? cross(b - a, d - a) / base : 0.0;
      // A proper corner blocked by others comes before one that is turned; of each kind the flattest.
      const double rank = height > 0.0 ? -height : 10.0 * height;
      if (rank > best_height) {
        best_height = rank;
        best = c;
      }
    }
    return best;
  }

  void own(std::int32_t t, int side, const Corner& corner) {
    if (corner.owner != PlanarTriangulation::kNone) {
      result_.link(t, side, corner.owner, corner.side);
    } else if (corner.bridge > 0) {
      bridge_side(corner.bridge, t, side);
    }
  }

  void bridge_side(int bridge, std::int32_t t, int side) {
    half_.resize(static_cast<std::size_t>(bridges_) + 1, {PlanarTriangulation::kNone, 0});
    auto& [other, other_side] = half_[static_cast<std::size_t>(bridge)];
    if (other == PlanarTriangulation::kNone) {
      other = t;
      other_side = side;
    } else {
      result_.link(t, side, other, other_side);
    }
  }

  /// Cuts corner c off; returns the corner before it.
  std::int32_t cut(std::int32_t c) {
    const std::int32_t a = ring_[c].previous, d = ring_[c].next;
    const auto t = static_cast<std::int32_t>(result_.triangles.size());
    result_.triangles.push_back({{ring_[a].point, ring_[c].point, ring_[d].point}});
    own(t, 2, ring_[a]);
    own(t, 0, ring_[c]);
    ring_[a].next = d;
    ring_[d].previous = a;
    ring_[a].owner = t;
    ring_[a].side = 1;
    ring_[a].bridge = 0;
    ring_[c].gone = true;
    if (first_ == c) first_ = a;
    update_convexity(a);
    update_convexity(d);
    --count_;
    return a;
  }

  void close(std::int32_t c) {
    const std::int32_t d = ring_[c].next, e = ring_[d].next;
    const auto t = static_cast<std::int32_t>(result_.triangles.size());
    result_.triangles.push_back({{ring_[c].point, ring_[d].point, ring_[e].point}});
    own(t, 2, ring_[c]);
    own(t, 0, ring_[d]);
    own(t, 1, ring_[e]);
  }

  PlanarTriangulation& result_;
  const std::vector<Vec2>& points_;
  std::vector<const Loop*> all_loops_;
  std::vector<Corner> ring_;
  std::vector<std::pair<double, double>> touches_;
  std::vector<std::array<Vec2, 2>> bridge_ends_;
  Buckets buckets_;
  std::vector<std::pair<std::int32_t, int>> half_;
  std::int32_t first_ = 0;
  int count_ = 0, bridges_ = 0;
};

/// Which outer loop holds each hole: the smallest that contains its first corner, else the largest.
std::vector<std::vector<const Loop*>> holes_of(const std::vector<Vec2>& points,
                                               const std::vector<const Loop*>& outers,
                                               const std::vector<const Loop*>& holes) {
  std::vector<std::vector<const Loop*>> result(outers.size());
  std::vector<double> area;
  for (const Loop* outer : outers) area.push_back(area_of(points, *outer));
  for (const Loop* hole : holes) {
    std::size_t best = outers.size();
    for (std::size_t i = 0; i < outers.size(); ++i)
      if (contains(points, *outers[i], points[hole->front()]) &&
          (best == outers.size() || area[i] < area[best]))
        best = i;
    if (best == outers.size())
      best = static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
    result[best].push_back(hole);
  }
  return result;
}

}  // namespace

PlanarTriangulation triangulate_loops(std::vector<Vec2> points, const std::vector<Loop>& loops) {
  PlanarTriangulation result;
  result.points = std::move(points);
  std::vector<const Loop*> outers, holes;
  for (const Loop& loop : loops) (area_of(result.points, loop) > 0.0 ? outers : holes).push_back(&loop);
  const auto inside =
      outers.empty() ? std::vector<std::vector<const Loop*>>() : holes_of(result.points, outers, holes);
  for (std::size_t i = 0; i < outers.size(); ++i) {
    const std::size_t before = result.triangles.size();
    Clipper(result).run(*outers[i], inside[i]);
    if (result.triangles.size() <= before) {
      result.triangles.clear();
      return result;
    }
  }
  std::vector<std::int32_t> all(result.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  result.legalize(all);
  return result;
}

}  // namespace octet
