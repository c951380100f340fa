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
#include "app/scaled_sizes.h"

namespace octet {
namespace {

constexpr double kCloseEnough = 0.125;

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

MeshResult mesh_to_target(const Model& model, const MeshOptions& options,
                          const std::function<MeshResult(const MeshOptions&)>& mesh) {
  constexpr int kMostMeshes = 8;
  const double target = options.target_elements;
  const MeshOptions whole = with_default_size(model, options);
  // A guess by volume first, so that no tree is far too large.
  double volume = 0.0;
  for (int r = 1; r <= model.count(3); ++r) volume += model.region(r).volume;
  const double guess = kEdgePerOctant * std::cbrt(kTetsPerOctant * volume / target);
  double x = std::log(guess / whole.size), correction = 0.0;
  std::optional<MeshResult> best;
  std::vector<std::pair<double, double>>
      tried;  // scales and what their meshes were off by, logarithms of both
  // An incomplete mesh has no count worth having.
  const auto miss = [target](const MeshResult& result) {
    return std::pair(result.report.status != MeshStatus::kComplete,
                     std::abs(static_cast<double>(result.report.tets) / target - 1.0));
  };
  const auto sizes = [&](double log_scale) { return scaled_sizes(model, whole, std::exp(log_scale)); };
  for (int i = 0; i < kMostMeshes; ++i) {
    if (!crossing(tried)) x = log_scale_for(model, sizes, std::log(target) - correction, x);
    MeshResult result = mesh(sizes(x));
    const double count = static_cast<double>(std::max<std::size_t>(result.report.tets, 1));
    if (!best || miss(result) < miss(*best)) best = std::move(result);
    if (miss(*best) < std::pair(false, kCloseEnough)) break;
    correction = std::log(count / estimated_elements(model, plan_sizes(model, sizes(x))));
    const double off = std::log(count / target);
    const bool again =
        std::any_of(tried.begin(), tried.end(), [off](const auto& one) { return one.second == off; });
    if (again) break;  // the same octants: between these counts there is none
    tried.emplace_back(x, off);
    if (const auto between = crossing(tried)) x = *between;
  }
  return *std::move(best);
}

}  // namespace octet
