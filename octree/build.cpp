// SPDX-License-Identifier: BSD-3-Clause
// Refinement against the model and the size samples.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "geom/size_check.h"
#include "octree/balance.h"
#include "octree/gradation.h"
#include "octree/octree.h"

namespace octet {
namespace {

/// Lengths this much above a wish still meet it: it covers the rounding of the root.
constexpr double kSizeSlack = 1.0 + 1e-6;

/// Octants that are looked at between two questions whether to go on.
constexpr std::size_t kOctantsAQuestion = 16'384;

void ask(const OctreeRequest& request) {
  if (request.cancelled && request.cancelled()) throw Cancelled();
}

/// The octants of a tree so far, in all and inside or on the boundary. What is split later or by the balance
/// makes more of both: each is a lower bound.
struct Count {
  std::size_t all = 1, within = 0;
  std::size_t settled = 0;  ///< of `within`: at levels above the one in hand
};

/// What a field has wanted least so far, and where.
struct Wanted {
  double size = kNoSize;
  std::optional<Box3> box;
};

[[noreturn]] void throw_too_many(double octants, std::size_t most, const OctreeRequest& request,
                                 const Wanted& wanted = {}) {
  if (wanted.box)
    throw TooManyOctants(fmt::format("sizes over space, down to {:g}, need more than {} octants, the limit",
                                     wanted.size, most),
                         wanted.box);
  // Octants go with the third power of the size inside and the second on the boundary; the cube root errs
  // on the side of too small a size, and rounding up to two digits makes up for it.
  const double factor = std::cbrt(octants / static_cast<double>(most));
  throw TooManyOctants(
      fmt::format("a size of {:g} needs more than {:.2g} octants, the limit is {}: ask for about {:.2g}",
                  request.size, octants, most, request.size * factor * 1.05),
      std::nullopt);
}

/// Every part of the inside lies in an octant no larger than h: the volume alone is a lower bound.
void check_volume(const Model& model, const OctreeRequest& request) {
  double volume = 0.0;
  for (int tag = 1; tag <= model.count(3); ++tag) volume += model.region(tag).volume;
  const double least = volume / (request.size * request.size * request.size);
  const std::size_t most = std::min(request.max_octants, request.max_within);
  if (least > static_cast<double>(most)) throw_too_many(least, most, request);
}

void check_count(const Count& count, const OctreeRequest& request, const Wanted& wanted = {}) {
  if (count.all > request.max_octants)
    throw_too_many(static_cast<double>(count.all), request.max_octants, request, wanted);
  if (count.within > request.max_within)
    throw_too_many(static_cast<double>(count.within), request.max_within, request, wanted);
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
void find_places(const Model& model, const Root& root, int level, const OctreeRequest& request,
                 std::vector<Candidate>& octants) {
  for (std::size_t begin = 0; begin < octants.size(); begin += kOctantsAQuestion) {
    ask(request);
    const std::size_t end = std::min(begin + kOctantsAQuestion, octants.size());
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      Candidate& octant = octants[i];
      if (octant.place == Place::kInside) return;
      const Box3 box = root.box(octant_of(octant.key, level));
      if (model.near_boundary(box)) return;
      octant.region = model.region_at(box.centre());
      octant.place = octant.region != 0 ? Place::kInside : Place::kOutside;
    });
  }
}

/// Whether an octant is to be split for its own sake: above the level of the size asked for always, below it
/// where its region or the field want smaller ones.
class SplitRule {
 public:
  SplitRule(const PlacedRoot& placed, const OctreeRequest& request)
      : placed_(placed), request_(request), field_(checked(request.field)) {}

  [[nodiscard]] bool may_split(int level) const {
    return level < placed_.level ||
           (level < kDeepestLevel && (request_.field || !request_.region_size.empty()));
  }
  [[nodiscard]] bool operator()(const Candidate& octant, int level) {
    if (level < placed_.level) return true;
    double wanted = kNoSize;
    const auto region = static_cast<std::size_t>(octant.region);
    if (octant.place == Place::kInside && region < request_.region_size.size())
      wanted = request_.region_size[region];
    if (request_.field) wanted = std::min(wanted, asked(placed_.root.box(octant_of(octant.key, level))));
    return placed_.root.length(level) > wanted * kSizeSlack;
  }
  /// Of the field.
  [[nodiscard]] const Wanted& least() const { return least_; }

 private:
  [[nodiscard]] double asked(const Box3& box) {
    const double size = field_(box);
    if (size < least_.size) least_ = {size, box};
    return size;
  }

  const PlacedRoot& placed_;
  const OctreeRequest& request_;
  SizeField field_;
  Wanted least_;
};

/// Splits octants of one level where the rule says so, and counts before it makes: the children.
std::vector<Candidate> split_level(const std::vector<Candidate>& octants, int level, SplitRule& rule,
                                   const OctreeRequest& request, SplitKeys& splits, Count& count) {
  std::vector<Candidate> children;
  count.within = count.settled;
  for (std::size_t i = 0; i < octants.size(); ++i) {
    if (i % kOctantsAQuestion == 0) ask(request);
    const Candidate& octant = octants[i];
    if (octant.place == Place::kOutside) continue;
    if (!rule(octant, level)) {
      ++count.settled;
      ++count.within;
      continue;
    }
    // Of an octant on the boundary one child at least is as well.
    count.within += octant.place == Place::kInside ? 8 : 1;
    count.all += 7;
    check_count(count, request, rule.least());
    splits.at[static_cast<std::size_t>(level)].push_back(octant.key);
    for (MortonKey child = 0; child < 8; ++child)
      children.push_back({octant.key << 3 | child, octant.place, octant.region});
  }
  return children;
}

/// Octants that meet the inside or the boundary are split until they have the size asked for there; those
/// outside stay.
SplitKeys split_for_model(const Model& model, const PlacedRoot& placed, const OctreeRequest& request) {
  SplitKeys splits;
  SplitRule rule(placed, request);
  Count count;
  std::vector<Candidate> octants{{}};
  for (int level = 0; !octants.empty() && rule.may_split(level); ++level) {
    std::vector<Candidate> children = split_level(octants, level, rule, request, splits, count);
    if (!rule.may_split(level + 1)) break;
    find_places(model, placed.root, level + 1, request, children);
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
      throw TooFine(fmt::format("a local size of {:g} is too small: the finest octants have length {:g}, set "
                                "a larger minimum size",
                                sample.size, root.length(kDeepestLevel)),
                    sample, root.length(kDeepestLevel));
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
  ask(request);
  splits = graded(std::move(splits), request.layers);
  ask(request);
  splits = balanced(std::move(splits));
  check_count({splits.terminal_count()}, request);
  ask(request);
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
