// SPDX-License-Identifier: BSD-3-Clause
// The region that holds a point.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "geom/model_data.h"

namespace octet {
namespace {

/// On which side of a nearest point x does p lie? x may be a face's, an edge's or a vertex' point. The sum of
/// the normals that point out of a region, each weighted by the angle of its facet at x, has a positive
/// product with p - x outside of the region and a negative one inside [Baerentzen & Aanaes 2005, theorem 1].
/// (The face with the largest |n.(p - x)| is right at edges, but not at acute vertices.) Each region around
/// x has its own sum, so interfaces between regions need no special case.
class AngleWeightedSigns {
 public:
  /// `height`: n.(p - x), n towards region[1]; `angle`: 2 pi within a face, pi on an edge.
  void add(const ModelFace& face, double angle, double height) {
    weight_ += angle;
    sum_of(face.region[0]) += angle * height;
    sum_of(face.region[1]) -= angle * height;
  }
  /// The one region whose sum is negative by more than `share` of the weight and distance; -1: not clear.
  [[nodiscard]] int region(double share, double distance) const {
    if (count_ == 1) return region_[0];
    const double least = share * weight_ * distance;
    int inside = -1;
    for (int k = 0; k < count_; ++k) {
      if (std::abs(sum_[k]) < least) return -1;
      if (sum_[k] > 0.0) continue;
      if (inside >= 0) return -1;
      inside = region_[k];
    }
    return inside;
  }

 private:
  double& sum_of(int region) {
    for (int k = 0; k < count_; ++k)
      if (region_[k] == region) return sum_[k];
    if (count_ == static_cast<int>(region_.size())) return overflow_;
    region_[count_] = region;
    return sum_[count_++];
  }
  static constexpr std::size_t kMost = 16;
  std::array<int, kMost> region_{};
  std::array<double, kMost> sum_{};
  double overflow_ = 0.0, weight_ = 0.0;
  int count_ = 0;
};

/// The angle of a facet around one of its points, given by barycentric weights.
double angle_at(const Facets& facets, const FacetFoot& f) {
  constexpr double kZero = 1e-9;
  int zeros = 0, corner = 0;
  for (int k = 0; k < 3; ++k) {
    zeros += f.weights[k] <= kZero;
    if (f.weights[k] > 0.5) corner = k;
  }
  if (zeros < 2) return zeros == 0 ? 2.0 * std::numbers::pi : std::numbers::pi;
  const auto& t = facets.triangles[f.triangle];
  const Vec3& x = facets.nodes[t[corner]];
  const Vec3 a = facets.nodes[t[(corner + 1) % 3]] - x, b = facets.nodes[t[(corner + 2) % 3]] - x;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The facets that hold x, as seen from p.
int region_by_star(const Model::Data& data, const Vec3& p, const Vec3& x, double same, double share) {
  AngleWeightedSigns signs;
  data.bvh.visit_within(x, same, 0, [&](const FacetFoot& f) {
    if (f.distance > same) return;
    signs.add(data.parts.faces[data.facets().face[f.triangle]], angle_at(data.facets(), f),
              data.facet_normal(f.triangle).dot(p - x));
  });
  return signs.region(share, (p - x).norm());
}

/// The sign of the facets' nearest feature, farther from them than they deviate. -1: not clear, because a
/// sheet of the other sign is about as near. At a cusp the facets of two sheets cross each other, and the
/// nearest may be the wrong one, so every facet that could hold the true nearest point must agree.
int region_by_facets(const Model::Data& data, const Vec3& p, const FacetFoot& nearest) {
  const Facets& facets = data.facets();
  const double same = 1e-6 * nearest.distance + data.tolerance;
  constexpr double kEdgeOn = 0.01, kClear = 1e-4;
  const int region = region_by_star(data, p, nearest.point, same, kClear);
  bool agreed = region >= 0;
  const double reach = nearest.distance + 2.0 * data.bvh.grow(nearest.triangle);
  data.bvh.visit_within(p, reach, 0, [&](const FacetFoot& f) {
    if (!agreed || (f.point - nearest.point).norm() <= same) return;
    const double height = data.facet_normal(f.triangle).dot(p - f.point);
    if (std::abs(height) <= kEdgeOn * f.distance) return;
    agreed = data.region_beside(facets.face[f.triangle], height) == region;
  });
  return agreed ? region : -1;
}

/// The region before the first hit of a ray, when every hit of it is a clear crossing.
std::optional<int> region_by_ray(const Model& model, const Model::Data& data, const Vec3& p,
                                 const Vec3& direction) {
  std::vector<Hit> hits;
  intersect_unsettled(data, p, p + direction * (2.0 * data.diagonal + (p - data.box.centre()).norm()), hits);
  if (hits.empty()) return 0;
  const Hit& first = hits.front();
  const double along = first.normal.dot(direction);
  if (first.end_point || first.on.dim != 2 || first.kind != HitKind::kTransversal || std::abs(along) < 0.05)
    return std::nullopt;
  return model.face(first.face).region[along > 0.0 ? 0 : 1];
}

/// Majority of the clear rays of a fixed set of directions in general position.
std::optional<int> region_by_rays(const Model& model, const Model::Data& data, const Vec3& p) {
  static constexpr std::array<std::array<double, 3>, 7> kDirections{{{0.5773, 0.5257, 0.6247},
                                                                     {-0.6113, 0.3541, 0.7077},
                                                                     {0.2903, -0.8419, 0.4549},
                                                                     {-0.4231, -0.5861, -0.6911},
                                                                     {0.8623, 0.2011, -0.4643},
                                                                     {-0.1709, 0.9137, -0.3687},
                                                                     {0.7043, -0.4127, -0.5779}}};
  std::array<int, 7> answer{};
  int answers = 0;
  for (const auto& d : kDirections) {
    const auto region = region_by_ray(model, data, p, Vec3(d[0], d[1], d[2]).normalized());
    if (region) answer[answers++] = *region;
    const int agree =
        answers == 0 ? 0 : static_cast<int>(std::count(answer.begin(), answer.begin() + answers, answer[0]));
    if (answers >= 3 && agree == answers) break;
  }
  int best = 0;
  std::optional<int> winner;
  for (int i = 0; i < answers; ++i) {
    const auto votes = static_cast<int>(std::count(answer.begin(), answer.begin() + answers, answer[i]));
    if (votes <= best) continue;
    best = votes;
    winner = answer[i];
  }
  return winner;
}

/// The sign beside a foot on an edge, by the exact normals of its faces.
int region_by_edge(const Model& model, const Model::Data& data, const Vec3& p, const Foot& foot) {
  AngleWeightedSigns signs;
  for (const int face : model.edge(foot.on.tag).faces) {
    const Vec3 normal = face == foot.face ? foot.normal : data.normal_on_edge(face, foot.on.tag, foot.point);
    if (normal.isZero()) continue;
    signs.add(model.face(face), std::numbers::pi, normal.dot(p - foot.point));
  }
  constexpr double kClear = 0.01;
  return signs.region(kClear, foot.distance);
}

/// Near the boundary: the sign of the exact nearest point; rays where that is nearly tangent.
int region_by_foot(const Model& model, const Model::Data& data, const Vec3& p, std::vector<FacetFoot> near) {
  const auto foot = closest_of(data, p, std::move(near));
  if (!foot) return 0;
  const double height = foot->normal.dot(p - foot->point);
  int region = -1;
  if (foot->on.dim == 2) {
    // Within a face p lies along the normal; where it does not, the foot is on a seam that is sharp.
    constexpr double kAlong = 0.98;
    if (std::abs(height) >= kAlong * foot->distance) region = data.region_beside(foot->face, height);
  } else if (foot->on.dim == 1) {
    region = region_by_edge(model, data, p, *foot);
  } else {
    // The facets around a vertex stand for its tangent cone: a coarse one, hence the wide margin.
    constexpr double kClear = 0.05;
    const Vec3& x = model.vertex(foot->on.tag).point;
    region = region_by_star(data, p, x, data.vertex_reach(foot->on.tag), kClear);
  }
  if (region >= 0) return region;
  if (foot->distance > data.tolerance)
    if (const auto vote = region_by_rays(model, data, p)) return *vote;
  return data.region_beside(foot->face, height);
}

}  // namespace

int Model::region_at(const Vec3& p) const {
  if (!data_->box.contains(p)) return 0;
  make_grid_once();
  const int known = data_->grid().at(p);
  return known != RegionGrid::kUnknown ? known : exact_region_at(p);
}

void Model::make_grid_once() const {
  if (data_->grid_made.load(std::memory_order_acquire)) return;
  std::call_once(data_->grid_begun, [this] {
    data_->made_grid =
        RegionGrid(data_->bvh, data_->box, [this](const Vec3& x) { return exact_region_at(x); });
    data_->grid_made.store(true, std::memory_order_release);
  });
}

int Model::exact_region_at(const Vec3& p) const {
  std::vector<FacetFoot> near;
  data_->bvh.near(p, kInfinity, 0, near);
  if (near.empty()) return 0;
  const FacetFoot& nearest = nearest_of(near);
  const double band = 3.0 * data_->bvh.grow(nearest.triangle) + 8.0 * data_->tolerance;
  if (nearest.distance > band) {
    const int region = region_by_facets(*data_, p, nearest);
    if (region >= 0) return region;
  }
  return region_by_foot(*this, *data_, p, std::move(near));
}

}  // namespace octet
