// SPDX-License-Identifier: BSD-3-Clause
// A secant search in the logarithms of size and count: counts go with a power of the size between -2 and -3.
#include "app/target_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/element_estimate.h"
#include "app/octant_sizes.h"
#include "app/scaled_sizes.h"
#include "base/error.h"

namespace octet {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kCloseEnough = 0.125;
constexpr double kSameOctants = 0.01;  // logarithms of scales that are nearer are not told apart
constexpr int kMostMeshes = 10;
/// By what the logarithm of an estimate may miss what is wanted.
constexpr double kNearEstimate = 0.02;

/// By what powers of the size counts fall: nearly not where features decide, with the third in the interior.
constexpr double kLeastPower = 0.4, kMostPower = 3.0;
/// The longest step beyond all sizes tried, a logarithm.
const double kLongestStep = std::log(2.0);

/// A mesh that came out larger than a default mesh may be is tried again for so much of that.
constexpr double kSafeShare = 0.8;

/// The scale where the line between the tries above and below the target that are nearest to one another
/// meets it; none without both. Counts need not fall with every growth of the size.
std::optional<double> crossing(const std::vector<std::pair<double, double>>& tried) {
  std::optional<double> found;
  double nearest = 0.0;
  for (const auto& above : tried) {
    for (const auto& below : tried) {
      const double apart = std::abs(below.first - above.first);
      if (above.second < 0.0 || below.second >= 0.0 || (found && apart >= nearest)) continue;
      nearest = apart;
      const double share = std::clamp(above.second / (above.second - below.second), 0.2, 0.8);
      found = above.first + share * (below.first - above.first);
    }
  }
  return found;
}

/// How far at least to go where all tries are on one side of the target: from the one that is nearest to it,
/// with the power of the size that it and the next one show. Estimates know nothing of what features ask for.
double beyond(const std::vector<std::pair<double, double>>& tried) {
  std::vector<std::pair<double, double>> near(tried);
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) != std::abs(b.second) ? std::abs(a.second) < std::abs(b.second) : a < b;
  });
  const auto [x, off] = near.front();
  double power = kMostPower;
  if (near.size() > 1 && near[1].first != x)
    power = std::clamp((near[1].second - off) / (x - near[1].first), kLeastPower, kMostPower);
  return x + std::clamp(off / power, -kLongestStep, kLongestStep);
}

struct Made {
  double tets;
  bool complete;
};

/// That a mesh misses the target, and why as far as all that were made tell.
std::string note_of_miss(const Model& model, const MeshReport& report, const std::vector<Made>& made) {
  const auto off = [&](double tets) { return std::abs(std::log(tets / report.target_elements)); };
  double above = kUnbounded, below = 0.0;  // of complete ones, next to the target
  double faulty = static_cast<double>(std::max<std::size_t>(report.tets, 1));
  const double own = off(faulty);
  for (const Made& one : made) {
    if (!one.complete && off(one.tets) < off(faulty)) faulty = one.tets;
    if (one.complete && one.tets < report.target_elements) below = std::max(below, one.tets);
    if (one.complete && one.tets >= report.target_elements) above = std::min(above, one.tets);
  }
  std::string why = "no nearer number was found";
  if (off(faulty) < own)
    why = fmt::format("that of {:.0f}, which is the nearest, has faults", faulty);
  else if (below > 0.0 && above < kUnbounded)
    why = fmt::format("found were {:.0f} and {:.0f}, for numbers jump where octants halve", below, above);
  else if (below == 0.0 && report.size > model.diagonal())
    why = "the part's own features ask for so many, however large the size";
  return fmt::format("{:.6g} tetrahedra were asked for, the mesh has {}: {}", report.target_elements,
                     report.tets, why);
}

}  // namespace

MeshResult mesh_to_target(const Model& model, const MeshOptions& options,
                          const std::function<MeshResult(const MeshOptions&)>& mesh, SizeMemo* memo) {
  const double target = options.target_elements;
  if (target > static_cast<double>(options.max_elements))
    throw LimitError(
        fmt::format("{:.6g} elements to aim at are more than the limit of {}: raise --max-elements", target,
                    options.max_elements));
  const MeshOptions whole = with_default_size(model, options, memo);
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
  const auto planned = [&](double log_scale) { return plan_sizes(model, sizes(log_scale), memo); };
  std::vector<Made> made;
  for (int i = 0; i < kMostMeshes; ++i) {
    if (!crossing(tried)) {
      x = log_scale_for(model, planned, std::log(target) - correction, x, kNearEstimate);
      if (!tried.empty())
        x = tried.front().second > 0.0 ? std::max(x, beyond(tried)) : std::min(x, beyond(tried));
    }
    MeshResult result = mesh(sizes(x));
    const double count = static_cast<double>(std::max<std::size_t>(result.report.tets, 1));
    if (result.report.tets > 0) made.push_back({count, result.report.status == MeshStatus::kComplete});
    if (!best || miss(result) < miss(*best)) best = std::move(result);
    if (miss(*best) < std::pair(false, kCloseEnough)) break;
    correction = std::log(count / estimated_elements(model, planned(x)));
    const double off = std::log(count / target);
    const auto again =
        std::find_if(tried.begin(), tried.end(), [off](const auto& one) { return one.second == off; });
    if (again == tried.end()) {
      tried.emplace_back(x, off);
    } else if (std::abs(x - again->first) < kSameOctants) {
      break;  // between these counts there is none
    } else {
      again->first = x;  // the same octants up to here
    }
    if (const auto between = crossing(tried)) x = *between;
  }
  best->report.target_elements = target;
  if (miss(*best).second > kCloseEnough)
    best->report.notes.push_back(note_of_miss(model, best->report, made));
  return *std::move(best);
}

namespace {

MeshResult mesh_within_bounds(const Model& model, const MeshOptions& options, const BoundedMesher& mesh,
                              SizeMemo* memo) {
  const MeshOptions chosen = with_default_size(model, options, memo);
  const double most = most_by_default(model);
  std::optional<MeshResult> result;
  double count = 0.0;
  bool open = false;
  try {
    const bool bounded = has_free_sizes(options) && options.large_mesh != LargeMesh::kAtOnce;
    result = mesh(chosen, bounded ? most : kUnbounded);
    count = static_cast<double>(result->report.tets);
  } catch (const TooManyTets& many) {
    count = many.count;
    open = many.open;
  }
  // What was made is not made again for being a little larger: that would take all the time once more.
  const bool complete = result && result->report.status == MeshStatus::kComplete;
  if (result && (complete || !has_free_sizes(options) || count <= most)) return *std::move(result);
  // Counts go with the size to the power -2 at the boundary, of which such parts have much.
  const double scale = std::sqrt(count / (kSafeShare * most));
  MeshResult coarser = mesh(scaled_sizes(model, chosen, scale), kUnbounded);
  if (!result && (open || coarser.report.status == MeshStatus::kComplete)) return coarser;
  if (!result && options.large_mesh == LargeMesh::kNever) {
    coarser.report.left_large = count;
    return coarser;
  }
  if (!result) result = mesh(chosen, kUnbounded);
  const auto rank = [](const MeshResult& r) {
    return std::pair(r.report.status != MeshStatus::kComplete, r.report.tets);
  };
  return rank(coarser) < rank(*result) ? std::move(coarser) : *std::move(result);
}

/// A part that is thin all over has next to no mesh at a size that suits its faces' number. Nothing where
/// that would take too many elements, too.
std::optional<MeshResult> mesh_by_width(const Model& model, const MeshOptions& options,
                                        const BoundedMesher& mesh, const MeshReport& coarse, SizeMemo* memo) {
  constexpr double kWidths = 2.0;
  MeshOptions finer = options;
  finer.size = kWidths * 2.0 * coarse.cad_volume / coarse.cad_area;
  if (!(finer.size > 0.0 && finer.size < coarse.too_coarse)) return {};
  try {
    if (estimated_elements(model, plan_sizes(model, finer, memo)) > static_cast<double>(options.max_elements))
      return {};
    return mesh(finer, kUnbounded);
  } catch (const LimitError&) {
    return {};
  }
}

}  // namespace

MeshResult mesh_by_default(const Model& model, const MeshOptions& options, const BoundedMesher& mesh,
                           SizeMemo* memo) {
  MeshResult result = mesh_within_bounds(model, options, mesh, memo);
  if (result.report.too_coarse == 0.0 || !has_free_sizes(options)) return result;
  std::optional<MeshResult> finer = mesh_by_width(model, options, mesh, result.report, memo);
  if (!finer || finer->report.faults.size() >= result.report.faults.size()) return result;
  finer->report.too_coarse = std::max(finer->report.too_coarse, result.report.too_coarse);
  finer->report.left_large = result.report.left_large;
  return *std::move(finer);
}

}  // namespace octet
