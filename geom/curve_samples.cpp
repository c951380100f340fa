// SPDX-License-Identifier: BSD-3-Clause
// Points along a curve from which a search for the nearest point starts.
#include "geom/curve_samples.h"

#include <algorithm>
#include <string_view>

namespace octet {
namespace {

bool projects_globally(const Curve& curve) {
  const std::string_view kind = curve.kind();
  return kind == "line" || kind == "circle" || kind == "ellipse";
}

}  // namespace

CurveSamples::CurveSamples(const Curve& curve, double t0, double t1) {
  if (projects_globally(curve)) {
    t_ = {0.5 * (t0 + t1)};
    return;
  }
  constexpr int kSpans = 64;
  for (int i = 0; i <= kSpans; ++i) {
    t_.push_back(i == kSpans ? t1 : t0 + (t1 - t0) * i / kSpans);
    point_.push_back(curve.point(t_.back()));
  }
}

CurveFoot CurveSamples::nearest(const Curve& curve, const Vec3& p) const {
  const auto foot_at = [&](double t) {
    const Vec3 x = curve.point(t);
    return CurveFoot{t, x, (x - p).norm()};
  };
  if (point_.empty()) return foot_at(curve.project(p, t_.front()));
  struct Start {
    double d2;
    std::size_t i;
  };
  std::vector<Start> starts;
  const auto d2 = [&](std::size_t i) { return (point_[i] - p).squaredNorm(); };
  for (std::size_t i = 0; i < point_.size(); ++i) {
    const bool below_left = i == 0 || d2(i) <= d2(i - 1);
    const bool below_right = i + 1 == point_.size() || d2(i) <= d2(i + 1);
    if (below_left && below_right) starts.push_back({d2(i), i});
  }
  std::sort(starts.begin(), starts.end(),
            [](const Start& a, const Start& b) { return a.d2 != b.d2 ? a.d2 < b.d2 : a.i < b.i; });
  CurveFoot best = foot_at(t_.front());
  const auto keep_nearer = [&](const CurveFoot& f) {
    if (f.distance < best.distance) best = f;
  };
  keep_nearer(foot_at(t_.back()));
  for (std::size_t k = 0; k < std::min<std::size_t>(3, starts.size()); ++k) {
    keep_nearer(foot_at(t_[starts[k].i]));
    keep_nearer(foot_at(curve.project(p, t_[starts[k].i])));
  }
  return best;
}

}  // namespace octet
