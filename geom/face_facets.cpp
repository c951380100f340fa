// SPDX-License-Identifier: BSD-3-Clause
// Facets of one face between given points on its boundary.
#include "geom/face_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "geom/facet_bvh.h"
#include "geom/planar_triangulation.h"

namespace octet {
namespace {

constexpr int kPasses = 24;

/// A surface over the box of the loops.
class SampledBox {
 public:
  SampledBox(const SurfaceJets& surface, const std::vector<Vec2>& uv)
      : surface_(surface), lo_(uv.front()), size_(uv.front()) {
    for (const Vec2& p : uv) {
      lo_ = lo_.cwiseMin(p);
      size_ = size_.cwiseMax(p);
    }
    size_ -= lo_;
  }

  /// Mean lengths of the derivatives.
  [[nodiscard]] Vec2 mean_lengths() const {
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const SurfaceJet jet = jet_at({(i + 0.5) / kSide, (j + 0.5) / kSide});
        sum += Vec2(jet.du.norm(), jet.dv.norm());
      }
    const auto usable = [](double x) { return std::isfinite(x) && x > 0.0 ? x : 1.0; };
    return {usable(sum.x() / (kSide * kSide)), usable(sum.y() / (kSide * kSide))};
  }

  /// Whether the normal stays the same along lines of u (0) or v (1).
  [[nodiscard]] bool keeps_normal_along(int axis) const {
    for (const double line : kUneven) {
      const Vec3 first = normal(axis, line, kUneven[0]);
      for (const double share : kUneven)
        if (!(first.dot(normal(axis, line, share)) > 1.0 - 1e-9)) return false;
    }
    return true;
  }

  [[nodiscard]] Vec2 size() const { return size_; }

 private:
  static constexpr int kSide = 5;
  /// Where to look whether something stays the same. At even distances a thread of five turns did: it looks
  /// alike after each turn. Of these no two distances are to each other as small whole numbers.
  static constexpr std::array<double, kSide> kUneven{0.0877, 0.2769, 0.5321, 0.6933, 0.9114};

  [[nodiscard]] SurfaceJet jet_at(const Vec2& share) const {
    return surface_(lo_ + size_.cwiseProduct(share), 1);
  }

  [[nodiscard]] Vec3 normal(int axis, double line, double share) const {
    const SurfaceJet jet = jet_at(axis == 0 ? Vec2(share, line) : Vec2(line, share));
    return jet.du.cross(jet.dv).normalized();
  }

  const SurfaceJets& surface_;
  Vec2 lo_, size_;
};

/// In (u,v) scaled by this circles are nearly circles on the surface. A long face that is straight along its
/// length is shortened: a wire would get as many rows of facets as its radius goes into its length.
Vec2 metric_scale(const SurfaceJets& surface, const std::vector<Vec2>& uv) {
  constexpr double kLong = 2.0;
  const SampledBox box(surface, uv);
  Vec2 scale = box.mean_lengths();
  for (const int axis : {0, 1}) {
    const Vec2 extent = box.size().cwiseProduct(scale);
    const double longest = kLong * extent[1 - axis];
    if (extent[axis] > longest && longest > 0.0 && box.keeps_normal_along(axis))
      scale[axis] *= longest / extent[axis];
  }
  return scale;
}

/// The sides of the loops that another runs along the other way, point for point: slits, where an edge has
/// the face on both of its sides.
class Slits {
 public:
  Slits(const std::vector<Vec2>& points, const std::vector<std::vector<std::uint32_t>>& loops)
      : points_(points), loops_(loops) {
    if (!any_two_alike()) return;
    std::map<std::array<double, 4>, int> sides;
    for_each_side([&](const Vec2& a, const Vec2& b) { ++sides[{a.x(), a.y(), b.x(), b.y()}]; });
    for (const auto& [side, count] : sides)
      if (sides.contains({side[2], side[3], side[0], side[1]})) slits_.insert(side);
  }

  /// The points with slits open by a hair, which no ear can then be cut across.
  [[nodiscard]] std::vector<Vec2> opened() const {
    std::vector<Vec2> open = points_;
    if (slits_.empty()) return open;
    for (const auto& loop : loops_) {
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &before = points_[loop[(i + n - 1) % n]], &at = points_[loop[i]],
                   &after = points_[loop[(i + 1) % n]];
        // Where a slit ends its sides meet, and it may end where another loop or slit does.
        if (before == after)
          open[loop[i]] += kShort * (before - at);
        else
          open[loop[i]] += to_the_left(before, at) + to_the_left(at, after);
      }
    }
    return open;
  }

 private:
  /// Shares of a side's length. Ends that are one vertex may miss each other in (u,v) by the file's
  /// tolerance, beside which sides have been divided until they are short.
  static constexpr double kHair = 1e-7, kShort = 0.01;

  template <class Visit>
  void for_each_side(const Visit& visit) const {
    for (const auto& loop : loops_)
      for (std::size_t i = 0; i < loop.size(); ++i)
        visit(points_[loop[i]], points_[loop[(i + 1) % loop.size()]]);
  }

  /// A slit has points that it comes to twice, unless it is a single side.
  [[nodiscard]] bool any_two_alike() const {
    std::vector<std::pair<double, double>> sorted;
    for (const auto& loop : loops_)
      for (const std::uint32_t p : loop) sorted.emplace_back(points_[p].x(), points_[p].y());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }

  /// A hair to the left of a side of a slit, where the face is; nothing at others.
  [[nodiscard]] Vec2 to_the_left(const Vec2& a, const Vec2& b) const {
    if (!slits_.contains({a.x(), a.y(), b.x(), b.y()})) return Vec2::Zero();
    return kHair * Vec2(a.y() - b.y(), b.x() - a.x());
  }

  const std::vector<Vec2>& points_;
  const std::vector<std::vector<std::uint32_t>>& loops_;
  std::set<std::array<double, 4>> slits_;
};

/// Puts points where the facets are too far from the surface or too flat for its curvature.
class Refiner {
 public:
  Refiner(const SurfaceJets& surface, PlanarTriangulation& plane, const Vec2& scale,
          const FacetLimits& limits)
      : surface_(surface), plane_(plane), scale_(scale), limits_(limits), given_(plane.points.size()) {
    cosine_ = std::cos(limits.angle);
    for (std::uint32_t i = 0; i < plane.points.size(); ++i) add_point(i);
  }

  void run() {
    for (int pass = 0; pass < kPasses; ++pass)
      if (!split_all()) return;
  }

  /// Where there is no room for more points: how far the surface is at most from the middle of a triangle.
  [[nodiscard]] double off() const {
    double off = 0.0;
    if (full())
      for (const auto& triangle : plane_.triangles) off = std::max(off, centre_distance(triangle.corner));
    return off;
  }

  [[nodiscard]] std::vector<Vec3> inner_points() const {
    return {position_.begin() + static_cast<std::ptrdiff_t>(given_), position_.end()};
  }

 private:
  [[nodiscard]] Vec2 uv(const Vec2& p) const { return p.cwiseQuotient(scale_); }

  void add_point(std::uint32_t i) {
    const Vec2 at = uv(plane_.points[i]);
    const SurfaceJet jet = surface_(at, 1);
    const Vec3 across = jet.du.cross(jet.dv);
    const double length = across.norm();
    position_.push_back(jet.p);
    normal_.push_back(length > 0.0 ? Vec3(across / length) : Vec3::Zero());
  }

  [[nodiscard]] bool full() const { return plane_.points.size() - given_ >= limits_.max_points; }

  [[nodiscard]] bool side_too_coarse(std::uint32_t i, std::uint32_t j) const {
    constexpr double kLeast = 0.25;  // of the deflection: shorter sides may be as they are
    const Vec3 &a = position_[i], &b = position_[j];
    const double length = (b - a).norm();
    if (length <= kLeast * limits_.deflection) return false;
    const bool turns = normal_[i].squaredNorm() > 0.5 && normal_[j].squaredNorm() > 0.5 &&
                       normal_[i].dot(normal_[j]) < cosine_;
    if (turns) return true;
    for (const double share : {0.5, 0.25, 0.75}) {
      const Vec3 p = surface_(uv((1.0 - share) * plane_.points[i] + share * plane_.points[j]), 0).p;
      if (closest_on_triangle(p, a, b, b).distance > limits_.deflection) return true;
    }
    return false;
  }

  [[nodiscard]] double centre_distance(const std::array<std::uint32_t, 3>& c) const {
    const Vec3 p = surface_(uv((plane_.points[c[0]] + plane_.points[c[1]] + plane_.points[c[2]]) / 3.0), 0).p;
    return closest_on_triangle(p, position_[c[0]], position_[c[1]], position_[c[2]]).distance;
  }

  /// One pass over the sides and triangles there are; false: nothing was split.
  bool split_all() {
    bool split = false;
    const auto count = static_cast<std::int32_t>(plane_.triangles.size());
    fine_.resize(plane_.triangles.size());
    for (std::int32_t t = 0; t < count && !full(); ++t)
      if (!is_fine(t) && split_at(t)) split = true;
    return split;
  }

  /// Whether the triangle and its sides have been looked at, and are fine; such need no more looks.
  [[nodiscard]] bool is_fine(std::int32_t t) const {
    return static_cast<std::size_t>(t) < fine_.size() && fine_[t] == plane_.triangles[t].corner;
  }

  /// Splits a side of the triangle, or the triangle itself, where that is needed.
  bool split_at(std::int32_t t) {
    bool any_coarse = false;
    for (int k = 0; k < 3; ++k) {
      const auto& triangle = plane_.triangles[t];
      const std::int32_t beyond = triangle.neighbour[k];
      const std::uint32_t i = triangle.corner[(k + 1) % 3], j = triangle.corner[(k + 2) % 3];
      if (beyond == PlanarTriangulation::kNone || is_fine(beyond) || !side_too_coarse(i, j)) continue;
      any_coarse = true;
      if (const auto point = plane_.split_side(t, k)) {
        add_point(*point);
        return true;
      }
    }
    if (centre_distance(plane_.triangles[t].corner) <= limits_.deflection) {
      if (!any_coarse) fine_[t] = plane_.triangles[t].corner;
      return false;
    }
    add_point(plane_.split_triangle(t));
    return true;
  }

  const SurfaceJets& surface_;
  PlanarTriangulation& plane_;
  Vec2 scale_;
  FacetLimits limits_;
  std::size_t given_;
  double cosine_ = 1.0;
  std::vector<Vec3> position_, normal_;
  std::vector<std::array<std::uint32_t, 3>> fine_;  ///< per triangle: its corners when it was found fine
};

struct LoopSide {
  std::uint32_t loop = 0, side = 0;
  std::uint32_t a = 0, b = 0;  ///< points
  double lo = 0.0, hi = 0.0;   ///< in u
};

std::vector<LoopSide> sides_by_u(const FaceLoops& loops) {
  std::vector<LoopSide> sides;
  for (std::uint32_t l = 0; l < loops.loops.size(); ++l)
    for (std::uint32_t i = 0; i < loops.loops[l].size(); ++i) {
      LoopSide side{l, i, loops.loops[l][i], loops.loops[l][(i + 1) % loops.loops[l].size()]};
      std::tie(side.lo, side.hi) = std::minmax({loops.uv[side.a].x(), loops.uv[side.b].x()});
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(), [](const LoopSide& x, const LoopSide& y) {
    return std::tie(x.lo, x.loop, x.side) < std::tie(y.lo, y.loop, y.side);
  });
  return sides;
}

/// Whether the sides cross; sides that share a point or touch in an end do not.
bool cross(const std::vector<Vec2>& uv, const LoopSide& x, const LoopSide& y) {
  if (x.a == y.a || x.a == y.b || x.b == y.a || x.b == y.b) return false;
  const Vec2 &p = uv[x.a], &q = uv[x.b], &a = uv[y.a], &b = uv[y.b];
  return orient2d(p, q, a) * orient2d(p, q, b) < 0 && orient2d(a, b, p) * orient2d(a, b, q) < 0;
}

}  // namespace

FaceFacets facet_face(const SurfaceJets& surface, bool planar, const FaceLoops& loops,
                      const FacetLimits& limits) {
  FaceFacets result;
  if (loops.uv.empty()) return result;
  const Vec2 scale = metric_scale(surface, loops.uv);
  std::vector<Vec2> scaled;
  scaled.reserve(loops.uv.size());
  for (const Vec2& p : loops.uv) scaled.push_back(p.cwiseProduct(scale));
  PlanarTriangulation plane = triangulate_loops(Slits(scaled, loops.loops).opened(), loops.loops);
  if (plane.triangles.empty()) return result;
  Refiner refiner(surface, plane, scale, limits);
  if (!planar) refiner.run();
  result.off = refiner.off();
  result.uv = loops.uv;
  for (std::size_t i = loops.uv.size(); i < plane.points.size(); ++i)
    result.uv.push_back(plane.points[i].cwiseQuotient(scale));
  result.inner = refiner.inner_points();
  for (const auto& triangle : plane.triangles) result.triangles.push_back(triangle.corner);
  return result;
}

std::vector<LoopCrossing> loop_crossings(const FaceLoops& loops) {
  std::vector<LoopCrossing> crossings;
  const std::vector<LoopSide> sides = sides_by_u(loops);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size() && sides[j].lo <= sides[i].hi; ++j)
      if (cross(loops.uv, sides[i], sides[j]))
        crossings.push_back({{sides[i].loop, sides[j].loop}, {sides[i].side, sides[j].side}});
  return crossings;
}

}  // namespace octet
