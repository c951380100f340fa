// SPDX-License-Identifier: BSD-3-Clause
// Signed crossings along rays, exact ones for a point, of facets for a volume.
#include "geom/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "geom/facet_bvh.h"

namespace octet {
namespace {

/// Directions all over the sphere, none near an axis or a diagonal.
Vec3 direction(int i, int count) {
  constexpr double kGoldenTurn = std::numbers::pi * (3.0 - std::numbers::phi), kStart = 0.7310585786;
  const double z = 1.0 - 2.0 * (i + 0.5) / count, across = std::sqrt(1.0 - z * z);
  const double angle = kStart + kGoldenTurn * i;
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// +1 where the face, passed along its normal, is a way out of the region.
int sense_of(const ModelFace& face, int region) {
  return (face.region[0] == region ? 1 : 0) - (face.region[1] == region ? 1 : 0);
}

/// Nothing where the ray grazes a face, meets an edge or begins on the boundary.
std::optional<int> winding_along(const Model& model, int region, const Vec3& p, const Vec3& q,
                                 std::vector<Hit>& hits) {
  constexpr double kLeastCosine = 1e-3;
  hits.clear();
  model.intersect(p, q, hits);
  const Vec3 way = (q - p).normalized();
  int sum = 0;
  for (const Hit& hit : hits) {
    const double cosine = hit.normal.dot(way);
    if (hit.on.dim != 2 || hit.kind != HitKind::kTransversal || hit.end_point ||
        std::abs(cosine) < kLeastCosine)
      return std::nullopt;
    sum += sense_of(model.face(hit.face), region) * (cosine > 0.0 ? 1 : -1);
  }
  return sum;
}

/// Where a line parallel to an axis goes through the boundary of a region.
struct Passage {
  double at = 0.0;  ///< along the axis
  int region = 0;
  int step = 0;  ///< of the winding number
  bool after = false;
};

/// Winding numbers of the regions of a model along a line.
class Cover {
 public:
  void pass(const Passage& passage) { winding_[passage.region] += passage.step; }
  [[nodiscard]] bool covers() const {
    return std::any_of(winding_.begin(), winding_.end(), [](const auto& w) { return w.second >= 1; });
  }
  /// Beyond all passages: a line through a node or a side of facets may count it twice or never.
  [[nodiscard]] bool is_empty() const {
    return std::all_of(winding_.begin(), winding_.end(), [](const auto& w) { return w.second == 0; });
  }

 private:
  std::map<int, int> winding_;
};

class CoverComparison {
 public:
  CoverComparison(const Model& before, const Model& after, const std::vector<int>& regions)
      : before_(before), after_(after) {
    for (std::size_t i = 0; i < before.facets().triangles.size(); ++i) {
      const auto& bounds = before.face(before.facets().face[i]).region;
      for (const int region : regions)
        if (bounds[0] == region || bounds[1] == region)
          for (const Vec3& corner : facet_corners(before.facets(), i)) box_.add(corner);
    }
  }

  double run() {
    constexpr double kFirst = 0.3819660113, kAside = 0.7320508076;  // off the middles and diagonals of faces
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kLines * kLines; ++i)
        look_along(axis, (i % kLines + kFirst) / kLines, (i / kLines + kAside) / kLines);
    return covered_ > 0.0 ? once_ / covered_ : std::numeric_limits<double>::infinity();
  }

 private:
  void look_along(int axis, double s, double t) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Vec3 size = box_.size();
    Vec3 p = before_.box().lo.cwiseMin(after_.box().lo), q = before_.box().hi.cwiseMax(after_.box().hi);
    p[axis] -= before_.diagonal();
    q[axis] += before_.diagonal();
    p[j] = q[j] = box_.lo[j] + s * size[j];
    p[k] = q[k] = box_.lo[k] + t * size[k];
    passages_.clear();
    collect(before_, false, axis, p, q);
    collect(after_, true, axis, p, q);
    std::stable_sort(passages_.begin(), passages_.end(),
                     [](const Passage& a, const Passage& b) { return a.at < b.at; });
    add_lengths(axis, p, size[j] * size[k]);
  }

  void collect(const Model& model, bool after, int axis, const Vec3& p, const Vec3& q) {
    const Facets& facets = model.facets();
    model.bvh().visit_segment(p, q, [&](std::uint32_t u) {
      const auto [a, b, c] = facet_corners(facets, u);
      const std::array<double, 3> side{area(axis, b, c, p), area(axis, c, a, p), area(axis, a, b, p)};
      const double sum = side[0] + side[1] + side[2];
      const bool through = sum > 0.0 ? *std::min_element(side.begin(), side.end()) > 0.0
                                     : sum < 0.0 && *std::max_element(side.begin(), side.end()) < 0.0;
      if (!through) return;
      Passage passage;
      passage.at = (side[0] * a[axis] + side[1] * b[axis] + side[2] * c[axis]) / sum;
      passage.after = after;
      const ModelFace& face = model.face(facets.face[u]);
      for (const int region : face.region) {
        if (region == 0) continue;
        passage.region = region;
        passage.step = -sense_of(face, region) * (sum > 0.0 ? 1 : -1);
        if (passage.step != 0) passages_.push_back(passage);
      }
    });
  }

  /// Twice the area of a triangle seen along the axis.
  static double area(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    return (a[j] - c[j]) * (b[k] - c[k]) - (a[k] - c[k]) * (b[j] - c[j]);
  }

  void add_lengths(int axis, const Vec3& line, double section) {
    Cover before, after;
    double covered = 0.0, once = 0.0;
    for (std::size_t i = 0; i < passages_.size(); ++i) {
      (passages_[i].after ? after : before).pass(passages_[i]);
      if (i + 1 == passages_.size()) break;
      const double from = std::max(passages_[i].at, box_.lo[axis]),
                   to = std::min(passages_[i + 1].at, box_.hi[axis]);
      if (to <= from) continue;
      if (before.covers()) covered += to - from;
      if (before.covers() != after.covers()) once += length_off_facets(axis, line, from, to);
    }
    if (!before.is_empty() || !after.is_empty()) return;
    covered_ += covered * section;
    once_ += once * section;
  }

  /// Of the line between two places, what is farther from all facets than these are from the surfaces.
  [[nodiscard]] double length_off_facets(int axis, Vec3 p, double from, double to) const {
    const int pieces = 1 + static_cast<int>(kLines * (to - from) / box_.size()[axis]);
    const double length = (to - from) / pieces;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      p[axis] = from + (i + 0.5) * length;
      bool near = false;
      for (const Model* model : {&before_, &after_})
        model->bvh().visit_within(p, 0.0, 0, [&](const FacetFoot&) { near = true; });
      if (!near) sum += length;
    }
    return sum;
  }

  static constexpr int kLines = 96;  ///< each way, for each axis
  const Model &before_, &after_;
  Box3 box_;
  std::vector<Passage> passages_;
  double covered_ = 0.0, once_ = 0.0;
};

}  // namespace

std::optional<int> winding_number(const Model& model, int region, const Vec3& p) {
  constexpr int kRays = 24, kAgree = 3;
  const double length = 2.0 * (model.diagonal() + (p - model.box().centre()).norm());
  std::vector<Hit> hits;
  std::map<int, int> votes;
  for (int i = 0; i < kRays; ++i) {
    // In an order that has the first rays far apart.
    const Vec3 way = direction(7 * i % kRays, kRays);
    const std::optional<int> found = winding_along(model, region, p, p + length * way, hits);
    if (found && ++votes[*found] == kAgree) return found;
  }
  return std::nullopt;
}

double share_covered_once(const Model& before, const Model& after, const std::vector<int>& regions) {
  return CoverComparison(before, after, regions).run();
}

}  // namespace octet
