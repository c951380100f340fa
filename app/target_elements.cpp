// SPDX-License-Identifier: BSD-3-Clause
// A secant search in the logarithms of size and count: counts go with a power of the size between -2 and -3.
#include "app/target_elements.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/element_estimate.h"
#include "app/octant_sizes.h"

namespace octet {
namespace {

constexpr double kCloseEnough = 0.125;
constexpr double kSlope = -2.5;  // the first guess of d log(count) / d log(size)

/// The logarithm of the scale at which log_count(log_scale) is `wanted`, near enough.
double solve(double start, double wanted, const std::function<double(double)>& log_count) {
  constexpr int kMostTrees = 8;
  double x = start, slope = kSlope, last_x = 0.0, last_y = 0.0;
  for (int i = 0; i < kMostTrees; ++i) {
    const double y = log_count(x);
    if (std::abs(y - wanted) < 0.02) break;
    if (i > 0 && std::abs(x - last_x) > 1e-6) slope = std::clamp((y - last_y) / (x - last_x), -4.0, -1.0);
    last_x = x;
    last_y = y;
    x += std::clamp((wanted - y) / slope, -1.5, 1.5);
  }
  return x;
}

/// The scale where the line between the nearest tries above and below the target meets it; none without both.
std::optional<double> crossing(const std::vector<std::pair<double, double>>& tried) {
  const std::pair<double, double>*above = nullptr, *below = nullptr;
  for (const auto& one : tried) {
    if (one.second >= 0.0 && (above == nullptr || one.second < above->second)) above = &one;
    if (one.second < 0.0 && (below == nullptr || one.second > below->second)) below = &one;
  }
  if (above == nullptr || below == nullptr) return std::nullopt;
  const double share = std::clamp(above->second / (above->second - below->second), 0.2, 0.8);
  return above->first + share * (below->first - above->first);
}

}  // namespace

MeshOptions scaled_sizes(const Model& model, const MeshOptions& options, double scale) {
  MeshOptions scaled = options;
  scaled.target_elements = 0.0;
  scaled.size = scale * global_size(model, options);
  scaled.max_size = 0.0;  // in the size already
  for (SizeAttribute& attribute : scaled.attributes) {
    if (attribute.elements > 0)
      attribute.elements = std::max(1, static_cast<int>(attribute.elements / scale));
    attribute.size *= scale;
  }
  if (options.background)
    scaled.background = [field = options.background, scale](const Box3& box) { return scale * field(box); };
  return scaled;
}

MeshResult mesh_to_target(const Model& model, const MeshOptions& options,
                          const std::function<MeshResult(const MeshOptions&)>& mesh) {
  constexpr int kMostMeshes = 8;
  const double target = options.target_elements;
  // A guess by volume first, so that no tree is far too large.
  double volume = 0.0;
  for (int r = 1; r <= model.count(3); ++r) volume += model.region(r).volume;
  const double guess = kEdgePerOctant * std::cbrt(kTetsPerOctant * volume / target);
  double x = std::log(guess / global_size(model, options)), correction = 0.0;
  std::optional<MeshResult> best;
  std::vector<std::pair<double, double>>
      tried;  // scales and what their meshes were off by, logarithms of both
  const auto miss = [target](const MeshResult& result) {
    return std::abs(static_cast<double>(result.report.tets) / target - 1.0);
  };
  for (int i = 0; i < kMostMeshes; ++i) {
    const auto log_count = [&](double at) {
      return std::log(
          estimated_elements(model, plan_sizes(model, scaled_sizes(model, options, std::exp(at)))));
    };
    if (!crossing(tried)) x = solve(x, std::log(target) - correction, log_count);
    MeshResult result = mesh(scaled_sizes(model, options, std::exp(x)));
    const double count = static_cast<double>(std::max<std::size_t>(result.report.tets, 1));
    if (!best || miss(result) < miss(*best)) best = std::move(result);
    if (miss(*best) < kCloseEnough) break;
    correction = std::log(count) - log_count(x);  // what the tree's count was off by
    tried.emplace_back(x, std::log(count / target));
    if (const auto between = crossing(tried)) x = *between;
  }
  return *std::move(best);
}

}  // namespace octet
