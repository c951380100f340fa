// SPDX-License-Identifier: BSD-3-Clause
// Sides of facets, piece by piece, against the facets of faces whose boxes they meet.
#include "geom/touch_places.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/golden_section.h"
#include "geom/facet_bvh.h"
#include "geom/shared_bounds.h"

namespace octet {
namespace {

bool have_common_region(const ModelFace& a, const ModelFace& b) {
  return std::any_of(a.region.begin(), a.region.end(),
                     [&](int r) { return r != 0 && (r == b.region[0] || r == b.region[1]); });
}

/// A box along the principal axes of points: tight about a thin face whichever way it lies.
class OwnBox {
 public:
  explicit OwnBox(const std::vector<Vec3>& points) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : points) centre += p / static_cast<double>(points.size());
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points) second += (p - centre) * (p - centre).transpose();
    axes_ = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors().transpose();
    for (const Vec3& p : points) box_.add(axes_ * p);
  }

  /// No more than the square of the distance between the box and a segment.
  [[nodiscard]] double squared_gap(const Vec3& from, const Vec3& to) const {
    const Vec3 p = axes_ * from, q = axes_ * to;
    const Vec3 below = box_.lo - p.cwiseMax(q), above = p.cwiseMin(q) - box_.hi;
    return below.cwiseMax(above).cwiseMax(0.0).squaredNorm();
  }

 private:
  Eigen::Matrix3d axes_;
  Box3 box_;
};

/// Facets of so many times the area of their face run to and fro: its loops or its surface are damaged.
constexpr double kWildFacets = 10.0;

/// For each face those it may touch: of a region that it bounds, where the boxes of their facets, grown by
/// what these are off, meet.
class TouchCandidates {
 public:
  TouchCandidates(const Model& model, double near)
      : of_(static_cast<std::size_t>(model.count(2)) + 1), boxes_(of_.size()) {
    const Facets& facets = model.facets();
    std::vector<double> area(of_.size(), 0.0);
    std::vector<std::vector<Vec3>> corners(of_.size());
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      const auto [a, b, c] = facet_corners(facets, t);
      corners[at(facets.face[t])].insert(corners[at(facets.face[t])].end(), {a, b, c});
      area[at(facets.face[t])] += triangle_area(a, b, c);
    }
    std::vector<int> order;
    for (int f = 1; f <= model.count(2); ++f) {
      own_boxes_.emplace_back(corners[at(f)]);
      if (corners[at(f)].empty() || area[at(f)] > kWildFacets * model.face(f).area) continue;
      for (const Vec3& p : corners[at(f)]) boxes_[at(f)].add(p);
      boxes_[at(f)] = boxes_[at(f)].grown(facets.deviation[at(f)] + near);
      order.push_back(f);
    }
    const auto low = [&](int f) { return boxes_[at(f)].lo.x(); };
    std::sort(order.begin(), order.end(), [&](int f, int g) { return low(f) < low(g); });
    for (auto i = order.begin(); i != order.end(); ++i)
      for (auto j = i + 1; j != order.end() && low(*j) <= boxes_[at(*i)].hi.x(); ++j)
        if (boxes_[at(*i)].overlaps(boxes_[at(*j)]) && have_common_region(model.face(*i), model.face(*j)) &&
            !have_common_edge(model.face(*i), model.face(*j))) {
          of_[at(*i)].push_back(*j);
          of_[at(*j)].push_back(*i);
        }
  }

  [[nodiscard]] const std::vector<int>& of(int face) const { return of_[at(face)]; }
  /// Of the face's facets, grown.
  [[nodiscard]] const Box3& box(int face) const { return boxes_[at(face)]; }
  /// About the face's facets.
  [[nodiscard]] const OwnBox& own_box(int face) const { return own_boxes_[at(face) - 1]; }

 private:
  static std::size_t at(int face) { return static_cast<std::size_t>(face); }

  std::vector<std::vector<int>> of_;
  std::vector<Box3> boxes_;        ///< per face tag, of those that are candidates
  std::vector<OwnBox> own_boxes_;  ///< per face tag - 1
};

/// The sides of facets at which faces that touch come near to each other: those on model edges, and all of
/// faces that bend. A plane touches what does not bend up to an edge of either.
class FacetSides {
 public:
  FacetSides(const Model& model, const TouchCandidates& candidates) {
    const Facets& facets = model.facets();
    std::vector<Side> all;
    for (std::size_t t = 0; t < facets.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3 && !candidates.of(facets.face[t]).empty(); ++k) {
        const auto ends = std::minmax(facets.triangles[t][k], facets.triangles[t][(k + 1) % 3]);
        all.push_back({ends.first, ends.second, facets.face[t]});
      }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      for (end = i; end < all.size() && all[end].a == all[i].a && all[end].b == all[i].b;) ++end;
      const bool inside = end == i + 2 && all[i].face == all[i + 1].face;
      if (inside && model.is_plane(all[i].face)) continue;
      sides_.insert(sides_.end(), all.begin() + static_cast<std::ptrdiff_t>(i),
                    all.begin() + static_cast<std::ptrdiff_t>(inside ? i + 1 : end));
    }
  }

  struct Side {
    std::uint32_t a, b;
    std::int32_t face;
    auto operator<=>(const Side&) const = default;
  };
  [[nodiscard]] auto begin() const { return sides_.begin(); }
  [[nodiscard]] auto end() const { return sides_.end(); }

 private:
  std::vector<Side> sides_;
};

/// The nearest few places of each pair.
class NearPlaces {
 public:
  NearPlaces(const Model& model, double near) : model_(model), near_(near), candidates_(model, near) {
    const Facets& facets = model.facets();
    for (const FacetSides::Side& side : FacetSides(model, candidates_)) {
      const Vec3 from = facets.nodes[side.a], way = facets.nodes[side.b] - from;
      const double pieces = std::ceil(way.norm() / (kLongestPiece * model.diagonal()));
      for (double i = 0.0; i < pieces; ++i)
        look_along(side.face, from + (i / pieces) * way, from + ((i + 1.0) / pieces) * way);
    }
  }

  [[nodiscard]] TouchPlaces take() { return std::move(pairs_); }

 private:
  /// Shares of the diagonal: a piece of a side that is looked along at once, and what facets are off.
  static constexpr double kLongestPiece = 0.01, kLargestDeviation = 1e-3;
  static constexpr std::size_t kPlacesPerPair = 3;

  void look_along(int face, const Vec3& from, const Vec3& to) {
    const double half = 0.5 * (to - from).norm();
    Box3 box;
    box.add(from);
    box.add(to);
    box = box.grown(deviation_of(face));
    for (const int other : candidates_.of(face)) {
      if (!candidates_.box(other).overlaps(box)) continue;
      const double limit = deviation_of(face) + deviation_of(other) + near_;
      if (candidates_.own_box(other).squared_gap(from, to) > limit * limit) continue;
      for (const auto& [begin, end] : outside_of(about_common_vertices(model_, {face, other}), from, to))
        if (const auto found = nearest_of(from + begin * (to - from), from + end * (to - from), other, limit))
          add({found->first, found->second, 2.0 * half, {face, other}});
    }
  }

  /// The distance of a segment from a face's facets, if it is no more than `limit`, and the place: from place
  /// to facet and back a few times.
  [[nodiscard]] std::optional<std::pair<double, Vec3>> nearest_of(const Vec3& from, const Vec3& to, int face,
                                                                  double limit) const {
    constexpr int kRounds = 3;
    double reach = 0.5 * (to - from).norm() + limit;
    std::pair<double, Vec3> best{std::numeric_limits<double>::infinity(), 0.5 * (from + to)};
    for (int round = 0; round < kRounds; ++round) {
      const auto foot = model_.bvh().nearest(best.second, reach, face);
      if (!foot) break;
      const auto found = nearest_of(from, to, facet_corners(model_.facets(), foot->triangle));
      if (found.first >= best.first) break;
      best = found;
      reach = found.first;
    }
    if (best.first > limit) return std::nullopt;
    return best;
  }

  [[nodiscard]] double deviation_of(int face) const {
    return std::min(model_.facets().deviation[face], kLargestDeviation * model_.diagonal());
  }

  /// The distance of a segment from a triangle, which is convex along it, and the place.
  static std::pair<double, Vec3> nearest_of(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& c) {
    const auto distance = [&](double s) {
      return closest_on_triangle(from + s * (to - from), c[0], c[1], c[2]).distance;
    };
    constexpr int kCuts = 10;  // for a place to begin at
    std::pair best = golden_section(0.0, 1.0, kCuts, distance);
    for (const double end : {0.0, 1.0})
      if (const double d = distance(end); d < best.second) best = {end, d};
    return {best.second, from + best.first * (to - from)};
  }

  void add(const TouchPlace& place) {
    std::vector<TouchPlace>& places =
        pairs_[{std::min(place.face[0], place.face[1]), std::max(place.face[0], place.face[1])}];
    const auto nearer = [](const TouchPlace& a, const TouchPlace& b) { return a.distance < b.distance; };
    places.insert(std::upper_bound(places.begin(), places.end(), place, nearer), place);
    if (places.size() > kPlacesPerPair) places.pop_back();
  }

  const Model& model_;
  double near_;
  TouchCandidates candidates_;
  TouchPlaces pairs_;
};

}  // namespace

TouchPlaces touch_places(const Model& model, double near) { return NearPlaces(model, near).take(); }

}  // namespace octet
