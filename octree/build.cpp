// SPDX-License-Identifier: BSD-3-Clause
// Refinement against the model and the size samples.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "octree/balance.h"
#include "octree/gradation.h"
#include "octree/octree.h"

namespace octet {
namespace {

/// Lengths this much above a wish still meet it: it covers the rounding of the root.
constexpr double kSizeSlack = 1.0 + 1e-6;

[[noreturn]] void throw_too_many(double octants, const OctreeRequest& request) {
  // Octants go with the third power of the size inside and the second on the boundary; the cube root errs
  // on the side of too small a size, and rounding up to two digits makes up for it.
  const double factor = std::cbrt(octants / static_cast<double>(request.max_octants));
  throw LimitError(
      fmt::format("a size of {:g} needs more than {:.2g} octants, the limit is {}: ask for about {:.2g}",
                  request.size, octants, request.max_octants, request.size * factor * 1.05));
}

/// Every part of the inside lies in an octant no larger than h: the volume alone is a lower bound.
void check_volume(const Model& model, const OctreeRequest& request) {
  double volume = 0.0;
  for (int tag = 1; tag <= model.count(3); ++tag) volume += model.region(tag).volume;
  const double least = volume / (request.size * request.size * request.size);
  if (least > static_cast<double>(request.max_octants)) throw_too_many(least, request);
}

void check_count(const SplitKeys& splits, const OctreeRequest& request) {
  const std::size_t count = splits.terminal_count();
  if (count > request.max_octants) throw_too_many(static_cast<double>(count), request);
}

enum class Place : std::uint8_t { kOutside, kInside, kBoundary };

/// An octant on the way down: where it lies, and its region when it lies inside one.
struct Candidate {
  MortonKey key = 0;
  Place place = Place::kBoundary;
  int region = 0;
};

/// Where octants of one level lie, each by itself: the answer does not depend on the threads. Those inside
/// are known from their parents.
void find_places(const Model& model, const Root& root, int level, std::vector<Candidate>& octants) {
  tbb::parallel_for(std::size_t{0}, octants.size(), [&](std::size_t i) {
    Candidate& octant = octants[i];
    if (octant.place == Place::kInside) return;
    const Box3 box = root.box(octant_of(octant.key, level));
    if (model.near_boundary(box)) return;
    octant.region = model.region_at(box.centre());
    octant.place = octant.region != 0 ? Place::kInside : Place::kOutside;
  });
}

/// Whether an octant is to be split for its own sake: above the level of the size asked for always, below it
/// where its region or the field want smaller ones.
class SplitRule {
 public:
  SplitRule(const PlacedRoot& placed, const OctreeRequest& request) : placed_(placed), request_(request) {}

  [[nodiscard]] bool may_split(int level) const {
    return level < placed_.level ||
           (level < kDeepestLevel && (request_.field || !request_.region_size.empty()));
  }
  [[nodiscard]] bool operator()(const Candidate& octant, int level) const {
    if (level < placed_.level) return true;
    double wanted = kNoSize;
    const auto region = static_cast<std::size_t>(octant.region);
    if (octant.place == Place::kInside && region < request_.region_size.size())
      wanted = request_.region_size[region];
    if (request_.field)
      wanted = std::min(wanted, request_.field(placed_.root.box(octant_of(octant.key, level))));
    return placed_.root.length(level) > wanted * kSizeSlack;
  }

 private:
  const PlacedRoot& placed_;
  const OctreeRequest& request_;
};

/// Octants that meet the inside or the boundary are split until they have the size asked for there; those
/// outside stay.
SplitKeys split_for_model(const Model& model, const PlacedRoot& placed, const OctreeRequest& request) {
  SplitKeys splits;
  const SplitRule rule(placed, request);
  std::vector<Candidate> octants{{}};
  for (int level = 0; !octants.empty() && rule.may_split(level); ++level) {
    std::vector<Candidate> children;
    for (const Candidate& octant : octants) {
      if (octant.place == Place::kOutside || !rule(octant, level)) continue;
      splits.at[level].push_back(octant.key);
      for (MortonKey child = 0; child < 8; ++child)
        children.push_back({octant.key << 3 | child, octant.place, octant.region});
    }
    check_count(splits, request);
    if (!rule.may_split(level + 1)) break;
    find_places(model, placed.root, level + 1, children);
    octants = std::move(children);
  }
  return splits;
}

/// Only the last octant to be split is named: its ancestors follow from the balance.
void split_for_samples(SplitKeys& splits, const Root& root, std::span<const SizeSample> samples) {
  for (const SizeSample& sample : samples) {
    if (!(sample.size > 0.0)) throw InputError("a size sample must be a positive number");
    int level = 0;
    while (level <= kDeepestLevel && root.length(level) > sample.size * kSizeSlack) ++level;
    if (level > kDeepestLevel) {
      throw LimitError(
          fmt::format("a local size of {:g} is too small: the finest octants have length {:g}, set a larger "
                      "minimum size",
                      sample.size, root.length(kDeepestLevel)));
    }
    if (level == 0) continue;
    const MortonKey cell = morton_key(root.cell_of(sample.place));
    splits.at[level - 1].push_back(cell >> (3 * (kLatticeLevels - level + 1)));
  }
}

}  // namespace

Octree build_octree(const Model& model, const OctreeRequest& request, std::span<const SizeSample> samples) {
  const PlacedRoot placed = place_root(model.box(), request.size, request.shift);
  check_volume(model, request);
  SplitKeys splits = split_for_model(model, placed, request);
  split_for_samples(splits, placed.root, samples);
  splits = balanced(graded(std::move(splits), request.layers));
  check_count(splits, request);
  return Octree(placed.root.origin, placed.root.size, terminal_octants(splits));
}

Octree refine(const Octree& tree, std::span<const OctantId> octants) {
  SplitKeys splits = split_keys(tree.octants());
  for (const OctantId id : octants) {
    const Octant& o = tree[id];
    if (o.level == kDeepestLevel) continue;
    splits.at[o.level].push_back(morton_key(o.corner) >> (3 * (kLatticeLevels - o.level)));
  }
  return Octree(tree.origin(), tree.root_size(), terminal_octants(balanced(std::move(splits))));
}

}  // namespace octet
