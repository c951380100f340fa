// SPDX-License-Identifier: BSD-3-Clause
// One octree of the length asked for is weighed for all others.
#include "app/suited_octants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "app/element_estimate.h"
#include "app/octant_sizes.h"
#include "app/words.h"
#include "base/error.h"
#include "octree/octant_types.h"

namespace octet {
namespace {

/// Lengths are weighed in steps of so many an octave, and so many of them.
constexpr int kSteps = 48, kMostSteps = 36;

/// Samples that stand for fewer than this share of the elements decide too little.
constexpr double kOwnShare = 0.25;
/// Shares of the elements, as weighed and as counted, above which another length is not worth it.
constexpr double kWorthCounting = 0.92, kWorthTaking = 0.85;

/// How much shorter than `length`, in steps.
int steps_below(double length, double shorter) {
  return std::max(0, static_cast<int>(std::floor(kSteps * std::log2(length / shorter))));
}

/// The elements of an octree, by what made their octants.
class Shares {
 public:
  Shares(const Octree& tree, const std::vector<OctantType>& type, const std::vector<SizeSample>& samples,
         double length)
      : length_(length) {
    std::vector<const SizeSample*> least(tree.size(), nullptr);
    for (const SizeSample& sample : samples) {
      const SizeSample*& known = least[tree.find(sample.place).index()];
      if (known == nullptr || sample.size < known->size) known = &sample;
    }
    for (std::size_t o = 0; o < tree.size(); ++o)
      if (type[o] != OctantType::kOut) count(tree.length(tree.octants()[o].level), type[o], least[o]);
  }

  [[nodiscard]] double elements() const { return inside_ + boundary_ + sized_ + beside_; }

  /// What they weigh where octants are so many steps shorter.
  [[nodiscard]] double weight(int steps) const {
    const double shorter = static_cast<double>(steps) / kSteps;
    const double own = own_weight(steps);
    return inside_ * std::exp2(3.0 * shorter) + boundary_ * std::exp2(2.0 * shorter) + own +
           (sized_ > 0.0 ? own / sized_ * beside_ : 0.0);
  }

 private:
  /// By how many steps their size is below the length: the elements of squares as wide as the size.
  using Bins = std::array<double, std::size_t{kDeepestLevel + 2} * kSteps>;

  void count(double length, OctantType type, const SizeSample* sample) {
    const double tets = type == OctantType::kIn ? kTetsPerOctant : kTetsPerBoundaryOctant;
    if (sample != nullptr && sample->size < length_) {
      Bins& bins = sample->at_most ? at_most_ : nearest_;
      const auto bin = static_cast<std::size_t>(steps_below(length_, sample->size));
      bins[std::min(bin, bins.size() - 1)] += tets * std::pow(length / sample->size, 2);
      sized_ += tets;
    } else if (length < M_SQRT1_2 * length_) {
      beside_ += tets;
    } else {
      (type == OctantType::kIn ? inside_ : boundary_) += tets;
    }
  }

  [[nodiscard]] double own_weight(int steps) const {
    double weight = 0.0;
    for (std::size_t bin = 0; bin < at_most_.size(); ++bin) {
      if (at_most_[bin] == 0.0 && nearest_[bin] == 0.0) continue;
      // The longest octants that are no longer than the size.
      const int below = static_cast<int>(bin);
      const int halved = std::max(0, (below - steps + kSteps - 1) / kSteps);
      const double squares = std::exp2(2.0 * (steps + halved * kSteps - below) / kSteps);
      // A size to be near to is half an octave below what octants may have for it. As much is lost by octants
      // twice as large as it, by area, as is won: its own length weighs least.
      const double off = std::max(0.0, 2.0 / squares - 1.0);
      weight += at_most_[bin] * squares + nearest_[bin] * (squares + 2.0 * off);
    }
    return weight;
  }

  double length_;                         ///< asked for
  double inside_ = 0.0, boundary_ = 0.0;  ///< octants of that length
  double sized_ = 0.0, beside_ = 0.0;     ///< shorter ones: for a sample, and for the sake of neighbours
  Bins at_most_{}, nearest_{};
};

/// A sample stands for a square of its size at most.
bool may_decide(const Model& model, const SizePlan& plan) {
  constexpr double kTetsPerSample = 2.0 * kTetsPerOctant;
  double volume = 0.0;
  for (int tag = 1; tag <= model.count(3); ++tag) volume += model.region(tag).volume;
  return kTetsPerSample * static_cast<double>(plan.samples.size()) >
         kOwnShare * kTetsPerOctant * volume / std::pow(octant_request(plan).size, 3);
}

Shares shares_of(const Model& model, const SizePlan& plan) {
  const OctreeRequest request = octant_request(plan);
  const std::vector<SizeSample> samples = octant_samples(plan);
  const Octree tree = build_octree(model, request, samples);
  return {tree, octant_types(model, tree).type, samples, request.size};
}

std::string suited(const Model& model, SizePlan& plan) {
  const Shares shares = shares_of(model, plan);
  int best = 0;
  for (int steps = 1; steps <= kMostSteps; ++steps)
    if (shares.weight(steps) < shares.weight(best)) best = steps;
  if (shares.weight(best) > kWorthCounting * shares.weight(0)) return {};
  SizePlan shorter = plan;
  shorter.octaves = -static_cast<double>(best) / kSteps;
  const double elements = estimated_elements(model, shorter);
  if (elements > kWorthTaking * shares.elements()) return {};
  plan.octaves = shorter.octaves;
  return fmt::format(
      "edges of {:.4g} mm in place of {:.4g} mm, whose halves suit the sizes that the part asks for itself: "
      "about {} elements in place of {}",
      plan.asked * std::exp2(plan.octaves), plan.asked, about_text(elements), about_text(shares.elements()));
}

}  // namespace

std::string suit_octants(const Model& model, const SizeControl& control, SizePlan& plan) {
  if (!control.suit_own_sizes || !plan.wanted.empty() || plan.field || !may_decide(model, plan)) return {};
  try {
    return suited(model, plan);
  } catch (const LimitError&) {
    return {};  // who makes the plan's octree tells it in the user's words
  }
}

}  // namespace octet
