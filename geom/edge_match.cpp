// SPDX-License-Identifier: BSD-3-Clause
// Symmetric partners on neighbouring edges: a Newton search from the nearest sample.
#include "geom/edge_match.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace octet {

EdgeIndex::EdgeIndex(const Model& model, double cell)
    : model_(&model), cell_(cell), around_(static_cast<std::size_t>(model.count(1)) + 1) {
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.use != EdgeUse::kReal) continue;
    const int n = std::clamp(static_cast<int>(std::ceil(edge.length / (0.5 * cell))), 2, 100000);
    for (int i = 0; i <= n; ++i) {
      const double t = edge.t0 + (edge.t1 - edge.t0) * i / n;
      const Vec3 p = model.edge_point(e, t);
      cells_[key(p, 0, 0, 0)].push_back({e, t, p});
      around_[static_cast<std::size_t>(e)].add(p);
    }
    // Half a piece is as far as the curve can be from the nearest sample; pieces differ in length.
    Box3& box = around_[static_cast<std::size_t>(e)];
    box.lo.array() -= edge.length / n;
    box.hi.array() += edge.length / n;
  }
}

std::uint64_t EdgeIndex::key(const Vec3& p, int dx, int dy, int dz) const {
  const auto part = [&](double x, int d) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell_)) + d + (1 << 20)) &
           0x1fffff;
  };
  return (part(p.x(), dx) << 42) | (part(p.y(), dy) << 21) | part(p.z(), dz);
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
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dz = -1; dz <= 1; ++dz) {
        const auto cell = cells_.find(key(p, dx, dy, dz));
        if (cell == cells_.end()) continue;
        for (const Sample& s : cell->second)
          if (around_[static_cast<std::size_t>(s.edge)].squared_distance(p) <= reach * reach)
            near.push_back({&s, (s.point - p).squaredNorm()});
      }
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
  const double reach = std::min(max_distance, cell_);
  for (const Sample& start : nearest_samples(a, reach)) {
    EdgePartner partner;
    if (start.edge == edge || !mirror(a, tangent, start, partner)) continue;
    if ((partner.point - a).norm() <= reach) result.push_back(partner);
  }
  return result;
}

std::vector<EdgePartner> EdgeIndex::feet(const Vec3& p, double max_distance) const {
  std::vector<EdgePartner> result;
  const double reach = std::min(max_distance, cell_);
  for (const Sample& start : nearest_samples(p, reach)) {
    const EdgeFoot foot = model_->edge_project(start.edge, p, start.t);
    if (foot.distance <= reach) result.push_back({start.edge, foot.t, foot.point});
  }
  return result;
}

}  // namespace octet
