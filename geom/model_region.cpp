// SPDX-License-Identifier: BSD-3-Clause
// The region that holds a point.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geom/model_data.h"

namespace octet {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Beside a nearest point x that several faces share, the face with the largest |n.(p - x)| is the one p
/// looks at: no other face hides it, whatever the angles [Payne & Toga 1992]. At a cusp, where two faces
/// leave x in the same direction, they tie and contradict each other: `torn`.
class Beholder {
 public:
  void look(const Model::Data& data, int face, double height) {
    const int region = data.region_beside(face, height);
    const double weight = std::abs(height);
    for (int k = 0; k < count_; ++k)
      if (region_[k] == region) {
        most_[k] = std::max(most_[k], weight);
        return;
      }
    if (count_ == static_cast<int>(region_.size())) return;
    region_[count_] = region;
    most_[count_++] = weight;
  }
  [[nodiscard]] int winner() const {
    int best = 0;
    for (int k = 1; k < count_; ++k)
      if (most_[k] > most_[best]) best = k;
    return best;
  }
  [[nodiscard]] int region() const { return count_ == 0 ? -1 : region_[winner()]; }
  [[nodiscard]] double most() const { return count_ == 0 ? 0.0 : most_[winner()]; }
  [[nodiscard]] bool mixed() const { return count_ > 1; }
  [[nodiscard]] bool torn() const {
    constexpr double kTie = 1.001;
    const int best = count_ == 0 ? 0 : winner();
    for (int k = 0; k < count_; ++k)
      if (k != best && most_[k] * kTie >= most_[best]) return true;
    return false;
  }

 private:
  std::array<int, 8> region_{};
  std::array<double, 8> most_{};
  int count_ = 0;
};

/// The sign of the facets' nearest feature, farther from them than they deviate. -1: not clear, because a
/// sheet of the other sign is about as near. At a cusp the facets of two sheets cross each other, and the
/// nearest may be the wrong one, so every facet that could hold the true nearest point must agree.
int region_by_facets(const Model::Data& data, const Vec3& p, const FacetFoot& nearest) {
  const Facets& facets = data.facets();
  const double grow = data.bvh.grow(nearest.triangle);
  const double same = 1e-6 * nearest.distance + data.tolerance;
  constexpr double kEdgeOn = 0.01;
  Beholder here, all;
  const auto height = [&](const FacetFoot& f) { return data.facet_normal(f.triangle).dot(p - f.point); };
  here.look(data, facets.face[nearest.triangle], height(nearest));
  data.bvh.visit_within(p, nearest.distance + 2.0 * grow + same, 0, [&](const FacetFoot& f) {
    const double h = height(f);
    if ((f.point - nearest.point).norm() <= same)
      here.look(data, facets.face[f.triangle], h);
    else if (std::abs(h) > kEdgeOn * f.distance)
      all.look(data, facets.face[f.triangle], h);
  });
  const bool agreed = !here.torn() && (all.region() < 0 || (all.region() == here.region() && !all.mixed()));
  return agreed ? here.region() : -1;
}

/// The region before the first hit of a ray, when every hit of it is a clear crossing.
std::optional<int> region_by_ray(const Model& model, const Vec3& p, const Vec3& direction) {
  std::vector<Hit> hits;
  model.intersect(p, p + direction * (2.0 * model.diagonal() + (p - model.box().centre()).norm()), hits);
  if (hits.empty()) return 0;
  const Hit& first = hits.front();
  const double along = first.normal.dot(direction);
  if (first.end_point || first.on.dim != 2 || first.kind != HitKind::kTransversal || std::abs(along) < 0.05)
    return std::nullopt;
  return model.face(first.face).region[along > 0.0 ? 0 : 1];
}

/// Majority of the clear rays of a fixed set of directions in general position.
std::optional<int> region_by_rays(const Model& model, const Vec3& p) {
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
    const auto region = region_by_ray(model, p, Vec3(d[0], d[1], d[2]).normalized());
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

/// Faces that hold the foot: one, those of its edge, or those of its vertex.
std::vector<int> faces_at(const Model& model, const Foot& foot) {
  if (foot.on.dim == 2) return {foot.face};
  if (foot.on.dim == 1) return model.edge(foot.on.tag).faces;
  std::vector<int> faces;
  for (const int e : model.vertex(foot.on.tag).edges)
    for (const int f : model.edge(e).faces) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (faces.empty()) faces.push_back(foot.face);
  return faces;
}

/// Near the boundary: the sign of the exact nearest point; rays where that is nearly tangent.
int region_by_foot(const Model& model, const Model::Data& data, const Vec3& p) {
  const auto foot = model.closest(p, kInfinity);
  if (!foot) return 0;
  const Vec3 away = p - foot->point;
  Beholder beholder;
  for (const int face : faces_at(model, *foot)) {
    if (face == foot->face) {
      beholder.look(data, face, foot->normal.dot(away));
      continue;
    }
    const auto near = data.bvh.nearest(foot->point, kInfinity, face);
    if (!near) continue;
    const Vec2 uv = data.surface(face).project(foot->point, data.seed(near->triangle, near->weights)).uv;
    beholder.look(data, face, data.normal(face, uv, near->triangle).dot(away));
  }
  const bool clear = !beholder.torn() && beholder.most() >= (foot->on.dim == 2 ? 0.5 : 0.02) * foot->distance;
  if (beholder.region() >= 0 && (clear || foot->distance <= data.tolerance)) return beholder.region();
  const auto vote = region_by_rays(model, p);
  return vote ? *vote : std::max(beholder.region(), 0);
}

}  // namespace

int Model::region_at(const Vec3& p) const {
  if (!data_->box.contains(p)) return 0;
  if (const int known = data_->grid.at(p); known != RegionGrid::kUnknown) return known;
  const auto nearest = data_->bvh.nearest(p, kInfinity);
  if (!nearest) return 0;
  const double band = 3.0 * data_->bvh.grow(nearest->triangle) + 8.0 * data_->tolerance;
  if (nearest->distance > band) {
    const int region = region_by_facets(*data_, p, *nearest);
    if (region >= 0) return region;
  }
  return region_by_foot(*this, *data_, p);
}

}  // namespace octet
