// SPDX-License-Identifier: BSD-3-Clause
// Scaling and rounding of sizes.
#include "app/octant_sizes.h"

#include <algorithm>
#include <cmath>

#include "app/element_limits.h"
#include "octree/even_walls.h"
#include "octree/gradation.h"

namespace octet {
namespace {

/// The longest octant that is nearest to a size: half an octave above it.
double longest_octant(double size) { return M_SQRT2 * size / kEdgePerOctant; }

/// Octaves from a length to the nearest one of the lattice: -1/2..1/2.
double octaves_off(double length, double lattice) {
  const double octaves = std::log2(length / lattice);
  return std::abs(octaves - std::round(octaves));
}

}  // namespace

// The phase of the lattice is tried in small steps. Who asks for a size at a place wants it more than the
// size of the rest, which counts half.
double lattice_length(double asked, const std::vector<double>& wanted) {
  constexpr int kSteps = 96;
  double best = 0.0, least = kNoSize;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double shift = 0.5 * i / kSteps, lattice = asked * std::exp2(shift);
    double worst = 0.5 * std::abs(shift);
    for (const double size : wanted) worst = std::max(worst, octaves_off(size, lattice));
    if (worst < least - 1e-9 || (worst < least + 1e-9 && std::abs(shift) < std::abs(best))) {
      least = worst;
      best = shift;
    }
  }
  return asked * std::exp2(best) / kEdgePerOctant;
}

// Where a region is coarser than the size asked for, its octants are so many levels above the lattice's.
OctreeRequest octant_request(const SizePlan& plan) {
  OctreeRequest request;
  const double shift = std::exp2(plan.octaves);
  const double lattice = lattice_length(shift * plan.asked, plan.wanted);
  const double levels = std::round(std::log2(shift * plan.size / kEdgePerOctant / lattice));
  request.size = std::exp2(levels) * lattice;
  request.layers = layers_of_growth(plan.growth);
  request.max_within = most_octants_within(plan.max_elements);
  request.max_octants = std::max(request.max_octants, plan.max_elements);
  request.cancelled = plan.cancelled;
  const auto& wanted = plan.region_size;
  if (std::any_of(wanted.begin(), wanted.end(), [](double size) { return size < kNoSize; }))
    for (const double size : wanted) request.region_size.push_back(longest_octant(size));
  if (plan.field)
    request.field = [field = plan.field](const Box3& box) { return longest_octant(field(box)); };
  return request;
}

std::vector<SizeSample> octant_samples(const SizePlan& plan) {
  std::vector<SizeSample> samples = plan.samples;
  for (SizeSample& sample : samples)
    if (!sample.at_most) sample.size = longest_octant(sample.size);
  return samples;
}

Octree planned_octree(const Model& model, const SizePlan& plan, const std::array<double, 3>& shift) {
  OctreeRequest request = octant_request(plan);
  request.shift = shift;
  try {
    return with_even_walls(model, build_octree(model, request, octant_samples(plan)));
  } catch (const TooManyOctants& many) {
    throw LimitError(too_many_elements(plan, many.finest()));
  } catch (const TooFine& fine) {
    throw LimitError(too_fine(model, fine));
  }
}

}  // namespace octet
