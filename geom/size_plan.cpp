// SPDX-License-Identifier: BSD-3-Clause
// Attributes turned into samples, region sizes and fields; the part's own wishes beside them.
#include "geom/size_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "geom/size_check.h"
#include "geom/size_memo.h"
#include "geom/size_wishes.h"
#include "geom/wish_cost.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

/// The most local refinement below the size asked for, when no smallest size is given.
constexpr double kFinestShare = 1.0 / 32.0;
/// The same for curvature alone: a small fillet is well served by elements of its own width.
constexpr double kFinestCurvedShare = 1.0 / 11.0;
/// The solder balls of a chip, whose size suits the chip, are small, but no feature of anything. Octants come
/// in powers of two: a region whose size is hardly smaller than the one asked for makes no difference.
constexpr double kSmallRegionShare = 0.75;
/// A region whose size is below this share of the smallest is smaller than one octant, and would vanish: it
/// is held to its own size, though to no less than a share of the part's diagonal, for an octree has so many
/// levels.
constexpr double kVanishingShare = 1.0 / 12.0;
constexpr double kFinestRegionShare = 1.0 / 32768.0;

/// Facets sampled between two questions whether to go on: at the limit of elements they have few samples
/// each.
constexpr std::size_t kFacetsBetweenQuestions = 64;

double attribute_size(const Model& model, const SizeAttribute& attribute, ModelRef entity) {
  return attribute.elements > 0 ? model.edge(entity.tag).length / attribute.elements : attribute.size;
}

class Planner {
 public:
  Planner(const Model& model, const SizeControl& control, SizeMemo* memo)
      : model_(model), control_(control), memo_(memo) {
    plan_.asked = global_size(model, control);
    plan_.min_size = control.min_size > 0.0 ? control.min_size : kFinestShare * plan_.asked;
    plan_.growth = control.growth;
    plan_.max_elements = control.max_elements;
    plan_.cancelled = control.cancelled;
    plan_.region_size.assign(static_cast<std::size_t>(model.count(3)) + 1, kNoSize);
    plan_.region_why.assign(plan_.region_size.size(), SizeReason::kAttribute);
  }

  SizePlan run() {
    resolve_attributes();
    add_features();
    add_walls();
    for (const auto& [entity, size] : wanted_) wish_for(entity, size, SizeReason::kAttribute);
    if (control_.region_scale > 0.0) hold_small_regions();
    if (plan_.size > plan_.asked) hold_other_regions();
    plan_.field = smaller_of(shapes(), floored(checked(control_.background)));
    return std::move(plan_);
  }

 private:
  void take(std::vector<SizeSample> samples) {
    plan_.samples.insert(plan_.samples.end(), samples.begin(), samples.end());
  }

  void add_features() {
    SizingOptions options;
    options.size = plan_.size;
    options.min_size = plan_.min_size;
    options.curvature_angle = control_.curvature_angle;
    options.curvature_floor = control_.curvature_floor > 0.0
                                  ? control_.curvature_floor
                                  : std::max(plan_.min_size, kFinestCurvedShare * plan_.size);
    options.edge_share = control_.short_edges ? 1.0 : 0.0;
    options.edge_gap_elements = control_.gap_elements;
    options.cancelled = control_.cancelled;
    take(memo_ != nullptr ? memo_->features.sizes(model_, options) : feature_sizes(model_, options));
    if (control_.suit_curvature) suit_curvature();
  }

  /// The mean octave of the sizes that curved faces want, as an angle on the circle of octaves; samples are a
  /// size apart, so that each stands for an element.
  void suit_curvature() {
    double x = 0.0, y = 0.0;
    for (const SizeSample& sample : plan_.samples) {
      if (sample.why != SizeReason::kCurvature || sample.on.dim != 2) continue;
      const double angle = 2.0 * M_PI * std::log2(sample.size / plan_.asked);
      x += std::cos(angle);
      y += std::sin(angle);
    }
    if (std::hypot(x, y) > 0.0)
      plan_.wanted.push_back(plan_.asked * std::exp2(std::atan2(y, x) / (2.0 * M_PI)));
  }

  void add_walls() {
    WallOptions options;
    options.size = plan_.size;
    options.min_size = plan_.min_size;
    options.wall_elements = control_.wall_elements;
    options.gap_elements = control_.gap_elements;
    options.budget = control_.wall_budget;
    options.cancelled = control_.cancelled;
    const WallSizes walls =
        memo_ != nullptr ? memo_->walls.sizes(model_, options) : wall_sizes_told(model_, options);
    take(walls.samples);
    plan_.thinnest_wall = walls.thinnest;
  }

  /// Entities with their sizes; a region may be coarser than the rest.
  void resolve_attributes() {
    plan_.size = plan_.asked;
    std::vector<SizedEntities> all;
    for (const SizeAttribute& attribute : control_.attributes) {
      SizedEntities& sized = all.emplace_back();
      for (const ModelRef entity : selected_entities(model_, attribute)) {
        const double size = within_limits(attribute_size(model_, attribute, entity));
        plan_.wanted.push_back(size);
        sized.emplace_back(entity, size);
        if (entity.dim == 3) plan_.size = std::max(plan_.size, size);
      }
      wanted_.insert(wanted_.end(), sized.begin(), sized.end());
    }
    for (std::size_t i = 0; i < all.size(); ++i) weigh(control_.attributes[i], all[i]);
  }

  /// Samples of a size far too small take minutes and all memory: what they would cost is known before.
  void weigh(SizeAttribute attribute, const SizedEntities& sized) {
    attribute.size = within_limits(attribute.size);
    WishCost cost = wish_cost(model_, attribute, sized, plan_.size, control_.max_elements);
    check_wish(model_, attribute, sized, cost, control_.max_elements);
    if (cost.elements > plan_.costliest.elements) plan_.costliest = std::move(cost);
  }

  void ask() const {
    if (control_.cancelled && control_.cancelled()) throw Cancelled();
  }

  /// Where a region is coarser than the size asked for, the others are held to that size one by one.
  void hold_other_regions() {
    std::vector<double> sizes(plan_.region_size.size(), kNoSize);
    for (std::size_t tag = 1; tag < sizes.size(); ++tag)
      if (plan_.region_size[tag] == kNoSize) sizes[tag] = plan_.asked;
    hold_regions(sizes, SizeReason::kGlobal);
  }

  void hold_small_regions() {
    std::vector<double> sizes = default_region_sizes(model_);
    for (std::size_t tag = 1; tag < sizes.size(); ++tag) {
      const double own = control_.region_scale * sizes[tag];
      const bool vanishes = own < kVanishingShare * plan_.min_size;
      sizes[tag] =
          within_limits(std::max(own, vanishes ? kFinestRegionShare * model_.diagonal() : plan_.min_size));
      if (sizes[tag] > kSmallRegionShare * plan_.asked || plan_.region_size[tag] != kNoSize)
        sizes[tag] = kNoSize;
    }
    hold_regions(sizes, SizeReason::kSmallRegion);
  }

  /// Each region, its faces included, to its size; no size for regions that are not held.
  void hold_regions(const std::vector<double>& sizes, SizeReason why) {
    for (std::size_t tag = 1; tag < sizes.size(); ++tag) {
      if (sizes[tag] >= plan_.region_size[tag]) continue;
      plan_.region_size[tag] = sizes[tag];
      plan_.region_why[tag] = why;
    }
    Wishes wishes(plan_.size, control_.min_size);
    const Facets& facets = model_.facets();
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      if (t % kFacetsBetweenQuestions == 0) ask();
      for (const int region : model_.face(facets.face[t]).region)
        if (region != 0 && sizes[static_cast<std::size_t>(region)] < kNoSize)
          wish_on_triangle(facet_corners(facets, t), sizes[static_cast<std::size_t>(region)],
                           {model_region(region), why}, wishes);
    }
    take(wishes.take());
  }

  void wish_for(ModelRef entity, double size, SizeReason why) {
    Wishes wishes(plan_.size, control_.min_size);
    const Wisher who{entity, why};
    if (entity.dim == 0) wish_around(model_.vertex(entity.tag).point, size, who, wishes);
    if (entity.dim == 1 && model_.edge(entity.tag).use != EdgeUse::kDegenerate)
      wish_on_edge(model_, entity.tag, model_.edge(entity.tag).t0, model_.edge(entity.tag).t1, size, who,
                   wishes);
    if (entity.dim == 2) wish_on_face(entity.tag, size, who, wishes);
    if (entity.dim == 3) {
      double& region_size = plan_.region_size[static_cast<std::size_t>(entity.tag)];
      region_size = std::min(region_size, size);
      plan_.region_why[static_cast<std::size_t>(entity.tag)] = why;
      for (const int face : model_.region(entity.tag).faces) wish_on_face(face, size, who, wishes);
    }
    take(wishes.take());
  }

  /// Two sizes around a vertex, so that all edges at it have the size, wherever it lies in its octant.
  static void wish_around(const Vec3& p, double size, const Wisher& who, Wishes& wishes) {
    for (int i = 0; i < 125; ++i)
      wishes.add(p + size * Vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2), size, who);
  }

  void wish_on_face(int face, double size, const Wisher& who, Wishes& wishes) {
    const Facets& facets = model_.facets();
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      if (facets.face[t] != face) continue;
      if (asked_++ % kFacetsBetweenQuestions == 0) ask();
      wish_on_triangle(facet_corners(facets, t), size, who, wishes);
    }
  }

  [[nodiscard]] double within_limits(double size) const {
    size = std::max(size, control_.min_size);
    return control_.max_size > 0.0 ? std::min(size, control_.max_size) : size;
  }

  [[nodiscard]] SizeField shapes() {
    std::vector<SizeAttribute> shapes;
    for (const SizeAttribute& attribute : control_.attributes) {
      if (!selected_entities(model_, attribute).empty()) continue;
      shapes.push_back(attribute);
      shapes.back().size = within_limits(attribute.size);
      plan_.wanted.push_back(shapes.back().size);
    }
    if (shapes.empty()) return {};
    return [shapes](const Box3& box) {
      double least = kNoSize;
      for (const SizeAttribute& shape : shapes)
        if (shape.size < least && shape_meets(shape, box)) least = shape.size;
      return least;
    };
  }

  [[nodiscard]] SizeField floored(SizeField field) const {
    if (!field || control_.min_size <= 0.0) return field;
    return [field = std::move(field), floor = control_.min_size](const Box3& box) {
      return std::max(field(box), floor);
    };
  }

  const Model& model_;
  const SizeControl& control_;
  SizeMemo* memo_;  ///< may be null
  SizePlan plan_;
  SizedEntities wanted_;   ///< of attributes
  std::size_t asked_ = 0;  ///< facets sampled, for questions whether to go on
};

}  // namespace

double global_size(const Model& model, const SizeControl& control) {
  const double size = control.size > 0.0 ? control.size : std::max(default_size(model), control.min_size);
  return control.max_size > 0.0 ? std::min(size, control.max_size) : size;
}

SizePlan plan_sizes(const Model& model, const SizeControl& control, SizeMemo* memo) {
  check_control(control);
  return Planner(model, control, memo).run();
}

SizePlan coarsened(SizePlan plan, double scale) {
  plan.asked *= scale;
  plan.size *= scale;
  plan.min_size *= scale;
  plan.octaves = 0.0;
  plan.wanted.clear();
  for (double& size : plan.region_size) {
    size *= scale;
    if (size > kSmallRegionShare * plan.asked) size = kNoSize;
  }
  for (SizeSample& sample : plan.samples) {
    if (sample.why == SizeReason::kSmallRegion) sample.size *= scale;
    const double floor =
        sample.why == SizeReason::kCurvature ? kFinestCurvedShare * plan.size : plan.min_size;
    sample.size = std::max(sample.size, floor);
  }
  std::erase_if(plan.samples, [&](const SizeSample& sample) {
    return sample.size >= (sample.why == SizeReason::kSmallRegion ? kSmallRegionShare : 1.0) * plan.size;
  });
  return plan;
}

}  // namespace octet
