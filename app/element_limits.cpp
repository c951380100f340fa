// SPDX-License-Identifier: BSD-3-Clause
// Limits of elements as limits of octants, in the user's words.
#include "app/element_limits.h"

#include <fmt/format.h>

#include <cmath>

#include "app/octant_sizes.h"
#include "geom/wish_cost.h"

namespace octet {
namespace {

/// The mesh of so many octants has no fewer elements than this share of what octants inside give: coarsely
/// graded octants, and those on the boundary, give fewer.
constexpr double kLeastShare = 0.8;

}  // namespace

// A tree under way counts an octant on the boundary that may have no child inside or on it: a little room.
std::size_t most_octants_within(std::size_t max_elements) {
  constexpr double kRoom = 1.25;
  return static_cast<std::size_t>(
      std::ceil(kRoom * static_cast<double>(max_elements) / (kLeastShare * kTetsPerOctant)));
}

void check_volume(const Model& model, const SizeControl& control, double h) {
  double volume = 0.0;
  for (int r = 1; r <= model.count(3); ++r) volume += model.region(r).volume;
  const double elements = kTetsPerOctant * volume / std::pow(h / kEdgePerOctant, 3);
  if (control.attributes.empty() && elements > static_cast<double>(control.max_elements))
    throw LimitError(
        fmt::format("size {:.6g} mm needs about {:.2g} elements, more than the limit of {}; ask for a larger "
                    "size{}",
                    h, elements, control.max_elements, or_raise(control.max_elements)));
}

void check_octants(const SizePlan& plan, std::size_t within) {
  const double elements = kTetsPerOctant * static_cast<double>(within);
  if (kLeastShare * elements > static_cast<double>(plan.max_elements))
    throw LimitError(too_many_elements(plan, std::nullopt, elements));
}

std::string too_many_elements(const SizePlan& plan, const std::optional<Box3>& finest, double elements) {
  constexpr double kMuch = 0.25;
  const auto most = static_cast<double>(plan.max_elements);
  if (plan.costliest.elements > most) return too_costly(plan.costliest, plan.max_elements);
  const std::string many =
      elements > 0.0
          ? fmt::format("about {:.2g} elements, more than the limit of {}", elements, plan.max_elements)
          : fmt::format("more than the limit of {} elements", plan.max_elements);
  if (finest && plan.field) {
    const Vec3 at = finest->centre();
    return fmt::format(
        "sizes over space, {:.3g} mm at ({:.6g}, {:.6g}, {:.6g}), need {}; ask for larger ones, set "
        "--min-size{}",
        plan.field(*finest), at.x(), at.y(), at.z(), many, or_raise(plan.max_elements));
  }
  const std::string costly =
      plan.costliest.elements > kMuch * most ? plan.costliest.wish + " and " : std::string();
  return fmt::format(
      "size {:.6g} mm, with {}the part's small features, needs {}; ask for a larger size, set --min-size{}",
      plan.asked, costly, many, or_raise(plan.max_elements));
}

std::string too_fine(const Model& model, const TooFine& fine) {
  const SizeSample& sample = fine.sample();
  const std::string where = sample.on.valid() ? " on " + model.describe(sample.on) : std::string();
  return fmt::format(
      "a size{} is too small for the part's extent: the finest octants give edges of {:.3g} mm; ask for a "
      "larger size there, or set --min-size",
      where, kEdgePerOctant * fine.finest());
}

}  // namespace octet
