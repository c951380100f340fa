// SPDX-License-Identifier: BSD-3-Clause
// Facets are halved until they are no longer than the thickness they see along their normals.
#include "geom/wall_sizing.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "base/blocks.h"
#include "base/error.h"
#include "base/size_field.h"
#include "geom/creases.h"
#include "geom/facet_bvh.h"
#include "geom/size_wishes.h"

namespace octet {
namespace {

/// Least cosine between a sheet's normal and a ray that meets it face on: normals 135 degrees apart and more.
constexpr double kFacesTheProbe = 0.7071;

/// Facets that one task looks from, and that all do between two questions whether to go on.
constexpr std::size_t kFacetsATask = 64, kFacetsAQuestion = 2048;

/// Tetrahedra in the cube of their mean edge length, as the octree makes them (12 in an octant).
constexpr double kTetsPerCube = 9.4;

/// Facets that a ray is held against one by one; among more each ray finds its own.
constexpr std::size_t kMany = 256;

/// Rays meet a facet so far beyond its sides, in shares of it.
constexpr double kRim = -1e-9;

/// What a ray among countless facets takes (4 us), in the time of an element's whole way through the run.
/// Slivers of facets are halved along their length until they are as short as their wish, and by their area
/// alone a search of minutes would be within the budget.
constexpr double kElementsPerRay = 0.2;
/// The same of each facet that a ray is held against: among slivers longer than the part they are thousands.
constexpr double kElementsPerFacet = kElementsPerRay / kMany;

/// How many octants of the length wished for fit across. Layers of octree vertices and of centres are half an
/// octant apart, and those that count keep 0.45 of one from both sheets (octree/seeds), so there are more
/// than 2 n - 2 of them. Edges pass over one layer at most, so no path across has fewer than n.
double octants_across(double n) { return n + 0.2; }

/// By face: those that share an edge with it. Between such there is a wedge, and no wall.
std::vector<std::vector<int>> faces_of_edges(const Model& model) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(model.count(2)) + 1);
  for (int e = 1; e <= model.count(1); ++e)
    for (const int f : model.edge(e).faces)
      for (const int g : model.edge(e).faces)
        if (f != g) neighbours[static_cast<std::size_t>(f)].push_back(g);
  for (int f = 1; f <= model.count(2); ++f)
    if (meets_itself(model, f)) neighbours[static_cast<std::size_t>(f)].push_back(f);
  for (auto& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}

/// The surfaces' unit normals in the middle of each facet. A facet that is thinner than it deviates may stand
/// at any angle to its surface.
std::vector<Vec3> sheet_normals(const Model& model) {
  const Facets& facets = model.facets();
  std::vector<Vec3> normals(facets.triangles.size());
  tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t t) {
    normals[t] =
        model.face_normal(facets.face[t], (facets.uv[t][0] + facets.uv[t][1] + facets.uv[t][2]) / 3.0);
    if (normals[t].norm() > 0.5) return;
    const auto [a, b, c] = facet_corners(facets, t);
    normals[t] = (b - a).cross(c - a).normalized();
  });
  return normals;
}

/// What all facets' searches share.
struct Search {
  const Model& model;
  const WallOptions& options;
  const std::vector<Vec3>& normals;
  const std::vector<std::vector<int>>& neighbours;  ///< per face: those that share an edge with it, ascending
  /// So far, added up in any order: a search that is far enough over the budget for rounding not to count is
  /// given up.
  std::atomic<double> elements{0.0};
  std::atomic<bool> given_up{false};
  std::atomic<double> least{kNoSize};  ///< wish so far, before the smallest size raises it

  [[nodiscard]] bool is_over(double sum, double slack = 1.0) const {
    return options.budget > 0.0 && sum > slack * options.budget;
  }
  void spend(double more) {
    constexpr double kForRounding = 1.000001;
    if (is_over(elements.fetch_add(more) + more, kForRounding)) given_up = true;
  }
  void lower_least(double wish) {
    double now = least;
    while (wish < now && !least.compare_exchange_weak(now, wish)) {
    }
  }
};

/// Looks from one facet after another.
class WallSizer {
 public:
  explicit WallSizer(Search& search)
      : search_(search),
        model_(search.model),
        facets_(search.model.facets()),
        normals_(search.normals),
        options_(search.options),
        wishes_(search.options.size, search.options.min_size) {}

  void look_from(std::size_t t) {
    if (!(normals_[t].norm() > 0.5)) return;
    const int face = facets_.face[t];
    for (const int side : {-1, 1}) {
      const int region = model_.face(face).region[side > 0 ? 1 : 0];
      const bool inside = region != 0;
      const double n = inside ? options_.wall_elements : options_.gap_elements;
      if (!(n > 0.0)) continue;
      if (search_.given_up) return;
      const std::array<Vec3, 3> corners = facet_corners(facets_, t);
      const Probe from{t,      face, side * normals_[t],
                       region, n,    {model_face(face), inside ? SizeReason::kWall : SizeReason::kGap}};
      const double before = elements_;
      if (look_ahead(corners, from)) probe(corners, from, 0);
      search_.lower_least(least_);
      search_.spend(elements_ - before);
    }
  }

  std::vector<SizeSample> take() { return wishes_.take(); }
  [[nodiscard]] double elements() const { return elements_; }
  [[nodiscard]] const ThinnestWall& thinnest() const { return thinnest_; }

 private:
  struct Probe {
    std::size_t facet;
    int face;
    Vec3 direction;  ///< unit, away from the sheet
    int region;      ///< that it goes into
    double n;        ///< elements across
    Wisher who;
  };

  /// A facet as the rays of one direction see it: the ray from p meets it where (p - corner) times u, v and
  /// their sum are within 0 and 1, after (p - corner) times `length`.
  struct Target {
    Vec3 corner, u, v, length;
  };

  /// Bounds of a triangle as seen along the rays, a little larger.
  struct Shadow {
    Eigen::Array2d lo, hi;
    [[nodiscard]] bool overlaps(const Shadow& other) const {
      return (lo <= other.hi && other.lo <= hi).all();
    }
  };

  /// A facet that rays may meet.
  struct Ahead {
    std::uint32_t facet;
    bool is_sheet;  ///< it faces the probe and is of no neighbouring face
    Shadow shadow;
    Target target;
  };

  [[nodiscard]] double reach_of(const Probe& probe) const { return octants_across(probe.n) * options_.size; }

  [[nodiscard]] Shadow shadow_of(const std::array<Vec3, 3>& corners) const {
    const auto at = [&](const Vec3& p) { return Eigen::Array2d(p.dot(across_[0]), p.dot(across_[1])); };
    const Eigen::Array2d a = at(corners[0]), b = at(corners[1]), c = at(corners[2]);
    const Eigen::Array2d lo = a.min(b).min(c), hi = a.max(b).max(c);
    const double slack = 1e-6 * (hi - lo).maxCoeff();
    return {lo - slack, hi + slack};
  }

  /// Whether the box is beside the rays from within the shadow. Not asked of rays along an axis, to which
  /// the boxes swept by them are close enough.
  [[nodiscard]] bool is_beside(const FloatBox& box, const Shadow& own) const {
    if (!oblique_) return false;
    const Vec3 lo(box.lo[0], box.lo[1], box.lo[2]), hi(box.hi[0], box.hi[1], box.hi[2]);
    const Vec3 middle = 0.5 * (lo + hi), half = (0.5 + 1e-6) * (hi - lo);
    for (int k = 0; k < 2; ++k) {
      const double at = across_[k].dot(middle), width = across_size_[k].dot(half);
      if (at + width < own.lo[k] || at - width > own.hi[k]) return true;
    }
    return false;
  }

  void look_along(const Vec3& direction) {
    int least = 0;
    direction.cwiseAbs().minCoeff(&least);
    across_[0] = direction.cross(Vec3::Unit(least)).normalized();
    across_[1] = direction.cross(across_[0]);
    for (int k = 0; k < 2; ++k) across_size_[k] = across_[k].cwiseAbs();
    constexpr double kAlongAxis = 0.999;
    oblique_ = direction.cwiseAbs().maxCoeff() < kAlongAxis;
  }

  /// What rays from the triangle sweep, a little larger.
  [[nodiscard]] Box3 swept(const std::array<Vec3, 3>& corners, const Probe& probe) const {
    const double reach = reach_of(probe);
    Box3 box;
    for (const Vec3& corner : corners) {
      box.add(corner);
      box.add(corner + reach * probe.direction);
    }
    return box.grown(1e-6 * reach);
  }

  /// Gathers the facets that rays from the triangle may meet, unless they are many: where sheets lie on one
  /// another each ray finds its own. Whether one of them may be a sheet.
  bool look_ahead(const std::array<Vec3, 3>& corners, const Probe& probe) {
    ahead_.clear();
    listed_.clear();
    bool any = false;
    std::size_t seen = 0;
    look_along(probe.direction);
    const Shadow own = shadow_of(corners);
    const auto beside = [&](const FloatBox& box) { return is_beside(box, own); };
    crowded_ = model_.bvh().any_in_box(swept(corners, probe), beside, [&](std::uint32_t t) {
      if (!ends(t, probe)) return false;
      const std::array<Vec3, 3> c = facet_corners(facets_, t);
      double height = 0.0;
      for (const Vec3& corner : c) height = std::max(height, (corner - corners[0]).dot(probe.direction));
      if (height < 0.5 * model_.tolerance()) return false;
      const Shadow shadow = shadow_of(c);
      if (!shadow.overlaps(own)) return false;
      if (++seen > kMany) return true;
      Ahead& facet = ahead_.emplace_back();
      facet.facet = t;
      facet.is_sheet = is_sheet(t, probe);
      facet.shadow = shadow;
      any = any || facet.is_sheet;
      return false;
    });
    if (any && !crowded_) list_ahead(probe.direction);
    return any || crowded_;
  }

  void list_ahead(const Vec3& direction) {
    for (std::size_t n = 0; n < ahead_.size(); ++n) {
      const std::optional<Target> target = target_of(ahead_[n].facet, direction);
      if (!target) continue;
      ahead_[n].target = *target;
      listed_.push_back(static_cast<std::uint32_t>(n));
    }
  }

  /// Whether the facet is another one, and what lies before it is the region of the probe. Facets of one face
  /// may lie on one another by as much as they deviate.
  [[nodiscard]] bool ends(std::uint32_t t, const Probe& probe) const {
    const auto& region = model_.face(facets_.face[t]).region;
    return t != probe.facet && region[normals_[t].dot(probe.direction) > 0.0 ? 0 : 1] == probe.region;
  }

  [[nodiscard]] bool is_sheet(std::uint32_t t, const Probe& probe) const {
    const auto& near = search_.neighbours[static_cast<std::size_t>(probe.face)];
    if (std::binary_search(near.begin(), near.end(), facets_.face[t])) return false;
    return std::abs(normals_[t].dot(probe.direction)) > kFacesTheProbe;
  }

  /// Length along the probe's direction to the next facet ahead from number `first` on, infinite where that
  /// is no sheet or beyond reach.
  [[nodiscard]] double thickness(const Vec3& p, const Probe& probe, std::size_t first) {
    const double reach = reach_of(probe);
    double nearest = kNoSize;
    bool is_sheet = false;
    if (crowded_) {
      elements_ += kElementsPerRay;
      std::uint32_t facet = 0;
      for (double length = reach / 64.0; !(nearest <= length) && length <= reach; length *= 8.0)
        nearest = first_along(p, length * probe.direction, probe, facet);
      is_sheet = nearest <= reach && this->is_sheet(facet, probe);
    }
    for (std::size_t n = first; n < listed_.size() && !crowded_; ++n) {
      elements_ += kElementsPerFacet;
      const Ahead& facet = ahead_[listed_[n]];
      const double s = along(p, facet.target);
      if (s >= nearest) continue;
      nearest = s;
      is_sheet = facet.is_sheet;
    }
    return is_sheet && nearest <= reach ? nearest : kNoSize;
  }

  /// Length to the first facet on the way, ties to the lowest number.
  [[nodiscard]] double first_along(const Vec3& p, const Vec3& way, const Probe& probe, std::uint32_t& facet) {
    double nearest = kNoSize;
    model_.bvh().visit_segment(p, p + way, [&](std::uint32_t t) {
      elements_ += kElementsPerFacet;
      const std::optional<Target> target = ends(t, probe) ? target_of(t, probe.direction) : std::nullopt;
      const double s = target ? along(p, *target) : kNoSize;
      if (s > nearest || (s == nearest && t > facet)) return;
      nearest = s;
      facet = t;
    });
    return nearest;
  }

  /// None where the facet stands on edge.
  [[nodiscard]] std::optional<Target> target_of(std::uint32_t t, const Vec3& direction) const {
    const auto [a, b, c] = facet_corners(facets_, t);
    const Vec3 e1 = b - a, e2 = c - a, h = direction.cross(e2);
    const double det = e1.dot(h);
    if (det == 0.0) return std::nullopt;
    return Target{a, h / det, e1.cross(direction) / det, e1.cross(e2) / det};
  }

  /// Length along the ray to a facet, infinite when it is missed or starts there.
  [[nodiscard]] double along(const Vec3& p, const Target& target) const {
    const Vec3 from = p - target.corner;
    const double u = from.dot(target.u), v = from.dot(target.v);
    if (!(u >= kRim && v >= kRim && u + v <= 1.0 - kRim)) return kNoSize;
    const double length = from.dot(target.length);
    return length > model_.tolerance() ? length : kNoSize;
  }

  /// The facets ahead of the triangle are among those from number `from` on.
  void probe(const std::array<Vec3, 3>& corners, const Probe& side, std::size_t from) {
    if (crowded_) return halve_or_wish(corners, side, from);
    const std::size_t first = listed_.size();
    const Shadow own = shadow_of(corners);
    bool any = false;
    for (std::size_t n = from; n < first; ++n) {
      const std::uint32_t listed = listed_[n];
      if (!ahead_[listed].shadow.overlaps(own)) continue;
      any = any || ahead_[listed].is_sheet;
      listed_.push_back(listed);
    }
    if (any) halve_or_wish(corners, side, first);
    listed_.resize(first);
  }

  void halve_or_wish(const std::array<Vec3, 3>& corners, const Probe& side, std::size_t first) {
    const auto& [a, b, c] = corners;
    const Vec3 middle = (a + b + c) / 3.0;
    const double across = octants_across(side.n);
    const double depth = thickness(middle, side, first);
    const double unlimited = depth / (side.n > 1.0 ? across : side.n);
    least_ = std::min(least_, unlimited);
    if (unlimited < thinnest_.wish && side.who.why == SizeReason::kWall)
      thinnest_ = {unlimited, 0.0, middle, side.face};
    const double wish = wishes_.floored(unlimited);
    const std::array<double, 3> length{(c - b).norm(), (a - c).norm(), (b - a).norm()};
    const auto longest =
        static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
    if (length[longest] > std::min(wish, options_.size)) {
      const Vec3 &top = corners[longest], &left = corners[(longest + 1) % 3],
                 &right = corners[(longest + 2) % 3];
      const Vec3 half = 0.5 * (left + right);
      probe({top, left, half}, side, first);
      if (search_.is_over(elements_)) return;
      probe({top, half, right}, side, first);
    } else if (wishes_.counts(wish)) {
      const double area = triangle_area(a, b, c);
      elements_ += kTetsPerCube * area * std::max(0.5 * depth, wish) / (wish * wish * wish);
      wish_through(middle, depth, wish, side);
      // A mesh may cut across at one octant that is coarser: none must be missed.
      if (side.n > 1.0)
        for (const Vec3& corner : corners) wish_through(corner, depth, wish, side);
    }
  }

  /// From the sheet to the middle; the other half is the other sheet's.
  void wish_through(const Vec3& p, double depth, double wish, const Probe& side) {
    for (double s = 0.0; s == 0.0 || s <= 0.5 * depth; s += wish)
      wishes_.add(p + s * side.direction, wish, side.who, side.n > 1.0);
  }

  Search& search_;
  const Model& model_;
  const Facets& facets_;
  const std::vector<Vec3>& normals_;
  const WallOptions& options_;
  Wishes wishes_;
  std::array<Vec3, 2> across_;         ///< unit, square to the rays in hand and to each other
  std::array<Vec3, 2> across_size_;    ///< of their components
  bool oblique_ = false;               ///< the rays
  std::vector<Ahead> ahead_;           ///< what rays from the facet in hand may meet
  std::vector<std::uint32_t> listed_;  ///< of these: what its first piece may meet, then each halving's
  bool crowded_ = false;               ///< they are too many for that
  double elements_ = 0.0;              ///< for all facets looked from
  double least_ = kNoSize;             ///< wish of theirs, before the smallest size raises it
  ThinnestWall thinnest_;              ///< likewise, of walls alone
};

/// The wishes of every `stride`-th facet; none when they pass the budget.
std::optional<WallSizes> wishes_within_budget(Search& search, std::size_t stride) {
  struct Found {
    std::vector<SizeSample> samples;
    double elements = 0.0;
    ThinnestWall thinnest;
  };
  const std::size_t count = (search.model.facets().triangles.size() + stride - 1) / stride;
  WallSizes all;
  double elements = 0.0;
  for (std::size_t begin = 0; begin < count; begin += kFacetsAQuestion) {
    if (search.options.cancelled && search.options.cancelled()) throw Cancelled();
    const std::size_t size = std::min(kFacetsAQuestion, count - begin);
    const std::vector<Found> found =
        map_blocks<Found>(size, kFacetsATask, [&](std::size_t first, std::size_t last) {
          WallSizer sizer(search);
          for (std::size_t i = first; i < last; ++i) sizer.look_from((begin + i) * stride);
          return Found{sizer.take(), sizer.elements(), sizer.thinnest()};
        });
    for (const Found& block : found) {
      all.samples.insert(all.samples.end(), block.samples.begin(), block.samples.end());
      elements += block.elements;
      if (block.thinnest.wish < all.thinnest.wish) all.thinnest = block.thinnest;
    }
    if (search.given_up || search.is_over(elements)) return std::nullopt;
  }
  return all;
}

}  // namespace

WallSizes wall_sizes_told(const Model& model, const WallOptions& options) {
  constexpr double kFinestShare = 1e-3;  // where no smallest size is given
  WallOptions tried = options;
  tried.min_size = std::max(options.min_size, kFinestShare * options.size);
  // Of countless facets a few tell whether the rest are worth asking.
  constexpr std::size_t kStride = 64, kCountless = 1000 * kStride;
  WallOptions share = options;
  share.budget *= 2.0 / kStride;
  const std::vector<Vec3> normals = sheet_normals(model);
  const std::vector<std::vector<int>> neighbours = faces_of_edges(model);
  double least = 0.0;  // wish in the last search
  const auto search = [&](const WallOptions& with, std::size_t stride) {
    Search all{model, with, normals, neighbours};
    auto sizes = wishes_within_budget(all, stride);
    least = all.least;
    return sizes;
  };
  for (;; tried.min_size *= 2.0) {
    if (tried.min_size >= options.size) return {{}, {least, options.size, Vec3::Zero(), 0}};
    if (tried.min_size <= least) continue;  // of what was too much nothing would change
    share.min_size = tried.min_size;
    if (model.facets().triangles.size() > kCountless && !search(share, kStride)) continue;
    if (auto sizes = search(tried, 1)) {
      sizes->thinnest.floor = tried.min_size;
      return *std::move(sizes);
    }
  }
}

std::vector<SizeSample> wall_sizes(const Model& model, const WallOptions& options) {
  return wall_sizes_told(model, options).samples;
}

const WallSizes& WallMemo::sizes(const Model& model, const WallOptions& options) {
  const auto question = [](const WallOptions& o) {
    return std::tie(o.size, o.min_size, o.wall_elements, o.gap_elements, o.budget);
  };
  if (options_ && question(*options_) == question(options)) return sizes_;
  sizes_ = wall_sizes_told(model, options);
  options_ = options;
  return sizes_;
}

}  // namespace octet
