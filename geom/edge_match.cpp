// SPDX-License-Identifier: BSD-3-Clause
// Symmetric partners on neighbouring edges: a Newton search from the nearest sample.
#include "geom/edge_match.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace octet {

EdgeIndex::EdgeIndex(const Model& model, double most) : model_(&model), most_(most) {
  std::vector<Box3> boxes;
  for (int e = 1; e <= model.count(1); ++e)
    if (model.edge(e).use == EdgeUse::kReal) add_edge(e, boxes);
  tree_ = BoxTree(boxes);
}

void EdgeIndex::add_edge(int e, std::vector<Box3>& boxes) {
  constexpr int kRun = 8;  // pieces between samples
  // Boxes around few samples would be far wider than the curve.
  constexpr int kFewPieces = 32;
  const ModelEdge& edge = model_->edge(e);
  const int n = static_cast<int>(std::clamp(std::ceil(edge.length / (0.5 * most_)), 2.0, 100000.0));
  const int parts = (kFewPieces + n - 1) / n;
  const auto at = [&](int i, int part) {
    return edge.t0 + (edge.t1 - edge.t0) * (i + double(part) / parts) / n;
  };
  for (int begin = 0; begin < n; begin += kRun) {
    const int end = std::min(begin + kRun, n);
    Box3 box;
    const auto first = static_cast<std::uint32_t>(samples_.size());
    for (int i = begin; i <= end; ++i) {
      samples_.push_back({e, at(i, 0), model_->edge_point(e, at(i, 0))});
      box.add(samples_.back().point);
      for (int part = 1; part < parts && i < end; ++part) box.add(model_->edge_point(e, at(i, part)));
    }
    // Half a part is as far as the curve can be from the nearest place; parts differ in length.
    boxes.push_back(box.grown(edge.length / (n * parts)));
    runs_.push_back({first, static_cast<std::uint32_t>(samples_.size())});
  }
}

bool EdgeIndex::mirror(const Vec3& a, const Vec3& tangent, const Sample& start, EdgePartner& out) const {
  const ModelEdge& edge = model_->edge(start.edge);
  double t = model_->edge_project(start.edge, a, start.t).t;
  const Vec3 d0 = model_->edge_derivative(start.edge, t).normalized();
  const double sense = d0.dot(tangent) < 0.0 ? -1.0 : 1.0;
  // Root of f(t) = (b(t) - a) . (T_a + sense * T_b(t)): the chord makes equal angles with both tangents.
  // Secant steps: f' is close to |b'| * (1 + T_a.T_b), which is never small for the chosen sense.
  for (int i = 0; i < 12; ++i) {
    const Vec3 b = model_->edge_point(start.edge, t);
    const Vec3 d = model_->edge_derivative(start.edge, t);
    const double speed = d.norm();
    if (speed <= 0.0) return false;
    const Vec3 direction = tangent + sense * d / speed;
    const double f = (b - a).dot(direction);
    const double slope = d.dot(direction);
    if (std::abs(slope) < 1e-9 * speed) return false;
    const double step = std::clamp(f / slope, -0.5 * (edge.t1 - edge.t0), 0.5 * (edge.t1 - edge.t0));
    t -= step;
    if (t <= edge.t0 || t >= edge.t1) return false;
    if (std::abs(step) < 1e-13 * (edge.t1 - edge.t0)) break;
  }
  out = {start.edge, t, model_->edge_point(start.edge, t)};
  return true;
}

std::vector<EdgeIndex::Sample> EdgeIndex::nearest_samples(const Vec3& p, double reach) const {
  struct Near {
    const Sample* sample;
    double distance;
    bool operator<(const Near& other) const {
      return std::tie(sample->edge, distance, sample->t) <
             std::tie(other.sample->edge, other.distance, other.sample->t);
    }
  };
  std::vector<Near> near;
  tree_.visit_within(p, reach, [&](std::uint32_t run) {
    for (std::uint32_t i = runs_[run].begin; i < runs_[run].end; ++i)
      near.push_back({&samples_[i], (samples_[i].point - p).squaredNorm()});
  });
  std::sort(near.begin(), near.end());
  std::vector<Sample> result;
  for (const Near& n : near)
    if (result.empty() || result.back().edge != n.sample->edge) result.push_back(*n.sample);
  return result;
}

std::vector<EdgePartner> EdgeIndex::partners(int edge, double t, double max_distance) const {
  const Vec3 a = model_->edge_point(edge, t);
  const Vec3 tangent = model_->edge_derivative(edge, t).normalized();
  std::vector<EdgePartner> result;
  const double reach = std::min(max_distance, most_);
  for (const Sample& start : nearest_samples(a, reach)) {
    EdgePartner partner;
    if (start.edge == edge || !mirror(a, tangent, start, partner)) continue;
    if ((partner.point - a).norm() <= reach) result.push_back(partner);
  }
  return result;
}

std::vector<EdgePartner> EdgeIndex::feet(const Vec3& p, double max_distance) const {
  std::vector<EdgePartner> result;
  const double reach = std::min(max_distance, most_);
  for (const Sample& start : nearest_samples(p, reach)) {
    const EdgeFoot foot = model_->edge_project(start.edge, p, start.t);
    if (foot.distance <= reach) result.push_back({start.edge, foot.t, foot.point});
  }
  return result;
}

}  // namespace octet
