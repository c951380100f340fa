// SPDX-License-Identifier: BSD-3-Clause
// What finalization does with a mesh, or with a block of one.
#include "finalize/schedule.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "finalize/improve.h"
#include "finalize/relax.h"
#include "finalize/shape.h"
#include "mesh/quality.h"

namespace octet {
namespace {

constexpr int kPasses = 8;
/// Sweeps of smoothing after a round of swaps for the mean, and after the last one.
constexpr int kSweeps = 1, kLastSweeps = 2;
/// Nothing is made worse than this for the mean (radians, 35 degrees): the tail of the shapes.
constexpr double kPolishAngle = 0.611;

/// The value that a tenth of the tetrahedra, or 3000, which take no time, come before, of those for which
/// value_of(t) has one; none where no more have.
template <class ValueOf>
std::optional<double> of_a_tenth(const WorkMesh& mesh, const ValueOf& value_of) {
  std::vector<double> values;
  std::size_t alive = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    ++alive;
    if (const std::optional<double> value = value_of(t)) values.push_back(*value);
  }
  const std::size_t few = std::max<std::size_t>(3000, alive / 10);
  if (values.size() <= few) return std::nullopt;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(few);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// While the worst elements are worked on, and nothing that failed before is taken as failed.
class Chase {
 public:
  explicit Chase(Workshop& shop) : shop_(shop), watch_(shop.flats) {
    shop_.forget_failures();
    set(true);
  }
  Chase(const Chase&) = delete;
  Chase& operator=(const Chase&) = delete;
  ~Chase() { set(false); }

 private:
  void set(bool on) {
    shop_.thorough = on;
    shop_.guard.guard_areas(on);
  }
  Workshop& shop_;
  FlatWatch watch_;
};

/// Works on what is below the goal, or below what `chase_goal` makes of it, until nothing gives.
void chase(Workshop& shop, double target, double goal, double polish, Observer& observer) {
  const Chase worst_first(shop);
  goal = chase_goal(shop.mesh, std::min(target, shape_of_angle(kThinAngle)), goal);
  for (int pass = 0; pass < kPasses; ++pass) {
    const PassResult result = improve_worst_first(shop, goal, observer);
    if (pass > 0 && result.bettered == 0) break;
    relax_around(shop, goal, polish);
    if (is_exhausted(result)) break;
  }
}

/// Works on the largest angles, which what came last has left or made.
void open_obtuse(Workshop& shop, Observer& observer) {
  constexpr int kObtusePasses = 3;
  const Chase worst_first(shop);
  const double limit = obtuse_limit(shop.mesh);
  for (int pass = 0; pass < kObtusePasses; ++pass) {
    const PassResult result = improve_obtuse(shop, limit, observer);
    if (result.bettered == 0 || is_exhausted(result)) break;
  }
}

/// Swaps, then moves vertices, for the mean.
void raise_mean(Workshop& shop, double floor, int sweeps, Observer& observer) {
  if (observer.cancelled()) throw Cancelled();
  swap_for_mean(shop, floor);
  relax_for_mean(shop, floor, sweeps);
}

/// Where shapes are known, most tetrahedra need no look at their angles.
DihedralExtremes extremes(const WorkMesh& mesh, double target) {
  const double of_target = squared_cotangent(target);
  DihedralCotangents range{0.0, 0.0};
  const auto angles = [&] {
    return DihedralRange{angle_of_cotangent(range.smallest), angle_of_cotangent(range.largest)};
  };
  std::size_t below = 0;
  double of_note = 1.0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (mesh.quality[t] > of_note || !mesh.alive(t)) continue;
    const DihedralCotangents own =
        dihedral_cotangents(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
    if (own.smallest > of_target) ++below;
    if (own.smallest <= range.smallest && own.largest >= range.largest) continue;
    range = {std::max(range.smallest, own.smallest), std::min(range.largest, own.largest)};
    // The shape is no more than the squared sine of any of the angles.
    const DihedralRange now = angles();
    of_note = 1.001 * shape_of_angle(std::max({now.smallest, std::numbers::pi - now.largest, target}));
  }
  return {angles(), below};
}

/// All that the scope asks for.
void improve_all(Workshop& shop, double target, double polish, double chased, Observer& observer) {
  if (shop.options.scope != FinalizeScope::kSmoothing) collapse_short_edges(shop);
  switch (shop.options.scope) {
    case FinalizeScope::kSmoothing:
    case FinalizeScope::kNicks:
      // Once: without swaps between, more passes only trade the shapes of others for those of the worst.
      relax_for_mean(shop, polish, kLastSweeps);
      relax_around(shop, chased, polish);
      break;
    case FinalizeScope::kFast:
      raise_mean(shop, polish, kSweeps, observer);
      chase(shop, target, target, polish, observer);
      break;
    case FinalizeScope::kAll:
      raise_mean(shop, polish, kSweeps, observer);
      collapse_for_mean(shop, polish);
      raise_mean(shop, polish, kSweeps, observer);
      chase(shop, target, chased, polish, observer);
      split_long_edges(shop, chased);
      if (shop.options.coarse_size_at) {
        shop.coarsening = true;
        collapse_short_edges(shop);
        raise_mean(shop, polish, kSweeps, observer);
        chase(shop, target, chased, polish, observer);
        split_long_edges(shop, chased);
      }
      raise_mean(shop, polish, kLastSweeps, observer);
      open_obtuse(shop, observer);
      break;
  }
}

}  // namespace

double chase_goal(const WorkMesh& mesh, double least, double goal) {
  const std::optional<double> lower = of_a_tenth(
      mesh, [&](TetId t) { return mesh.quality[t] < goal ? std::optional(mesh.quality[t]) : std::nullopt; });
  return lower ? std::max(*lower, least) : goal;
}

double obtuse_limit(const WorkMesh& mesh) {
  const std::optional<double> higher = of_a_tenth(mesh, [&](TetId t) -> std::optional<double> {
    // The shape is no more than the squared sine of any of the angles.
    if (mesh.quality[t] >= shape_of_angle(kObtuse)) return std::nullopt;
    const double largest =
        dihedral_cotangents(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3)).largest;
    return largest < squared_cotangent(kObtuse) ? std::optional(largest) : std::nullopt;
  });
  return higher ? angle_of_cotangent(*higher) : kObtuse;
}

bool is_exhausted(const PassResult& pass) {
  constexpr std::size_t kFew = 2000, kShare = 20;
  return pass.tried > kFew && kShare * pass.bettered < pass.tried;
}

bool is_worse(const DihedralExtremes& made, const DihedralExtremes& given) {
  constexpr double kAboutAsLarge = 0.9;
  const double least = given.range.smallest;
  return made.range.smallest < (made.below < given.below ? kAboutAsLarge * least : least);
}

Scheduled run_schedule(Workshop& shop, Chosen chosen, Observer& observer) {
  const FinalizeOptions& options = shop.options;
  const DihedralExtremes before = extremes(shop.mesh, options.target_dihedral);
  const double polish = shape_of_angle(kPolishAngle);
  const double target = shape_of_angle(options.target_dihedral);
  const double chased = shape_of_angle(std::max(kChaseAngle, options.target_dihedral));
  if (chosen == Chosen::kByScope) {
    improve_all(shop, target, polish, chased, observer);
  } else {
    chase(shop, target, options.scope == FinalizeScope::kFast ? target : chased, polish, observer);
    open_obtuse(shop, observer);
  }
  DihedralExtremes after = extremes(shop.mesh, options.target_dihedral);
  const double smallest = before.range.smallest;
  DihedralExtremes given = before;
  if (options.coarse_size_at) given.range.smallest = std::min(smallest, options.target_dihedral);
  Scheduled result;
  if (is_worse(after, given)) {
    shop.report = FinalizeReport{};
    after = before;
  } else {
    result.better = to_mesh(shop.mesh);
  }
  result.report = shop.report;
  result.report.min_dihedral_before = smallest;
  result.report.min_dihedral_after = after.range.smallest;
  result.report.max_dihedral_after = after.range.largest;
  result.report.below_target = after.below;
  return result;
}

}  // namespace octet
