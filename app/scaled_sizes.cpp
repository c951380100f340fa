// SPDX-License-Identifier: BSD-3-Clause
// A secant search in the logarithms of size and count: counts go with a power of the size between -2 and -3.
#include "app/scaled_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/element_estimate.h"
#include "geom/size_memo.h"

namespace octet {
namespace {

constexpr double kSlope = -2.5;  // the first guess of d log(count) / d log(size)

/// Coarser sizes by curvature leave six elements on a circle.
constexpr double kWidestAngle = M_PI / 3.0;

/// Elements that any part may have, and faces from which on a part may have more.
constexpr double kMost = 500'000.0, kManyFaces = 1000.0;
/// What a mesh without a size may be estimated at: of the elements that it may have this share. Estimates of
/// thin sheets are up to three times the truth, those of parts with many small features down to six tenths.
constexpr double kFewest = 4'000.0, kShareOfMost = 0.58, kUsualMost = kShareOfMost * kMost;
/// How many times larger than the part's own default size sizes may become for kMost where faces are many: at
/// 10 times small features alone decide where elements are.
constexpr double kCoarsestScale = 1.6;
/// Logarithm of a share by which an estimate may miss them: it is no truer than that, and each tree of a
/// search takes its time.
constexpr double kNear = 0.1;

/// A mesh without a size follows curved faces more closely as far as that leaves it below this estimate, or
/// costs no more than a quarter of its elements: where most of these are for something else.
constexpr double kSmallMesh = 40'000.0, kLittleMore = 1.25;

/// Whether nothing is asked for about curved faces, or for a number of elements, which all sizes serve.
bool has_free_curvature(const MeshOptions& options) {
  return options.curvature_angle == SizeControl().curvature_angle && options.curvature_floor == 0.0 &&
         options.target_elements == 0.0;
}

/// What a tree of a search promises; infinite for one that would have more octants than any search needs.
double elements_or_countless(const std::function<double()>& estimate) {
  try {
    return estimate();
  } catch (const LimitError&) {
    return std::numeric_limits<double>::infinity();
  }
}

struct Sized {
  MeshOptions options;
  SizePlan plan;
  double elements;  ///< estimated
};

Sized sized(const Model& model, const MeshOptions& options, SizeMemo& memo) {
  SizePlan plan = plan_sizes(model, options, &memo);
  const double elements = elements_or_countless([&] { return estimated_elements(model, plan); });
  return {options, std::move(plan), elements};
}

/// With as many elements on a circle as the mesh has room for. The least number that is more is tried first;
/// counts go about with its square, and what goes far beyond the room by this is not tried.
Sized with_rounder_faces(const Model& model, Sized given, SizeMemo& memo) {
  constexpr double kFarBeyond = 1.1;
  const double room = std::max(kSmallMesh, std::min(kUsualMost, kLittleMore * given.elements));
  const auto rounded = [&](double on_a_circle) {
    MeshOptions options = given.options;
    options.curvature_angle = 2.0 * M_PI / on_a_circle;
    return sized(model, options, memo);
  };
  const auto more = [&](double on_a_circle) {
    return on_a_circle * on_a_circle - std::pow(2.0 * M_PI / given.options.curvature_angle, 2);
  };
  Sized least = rounded(13.0);
  if (least.elements > room) return given;
  const double rise = (least.elements - given.elements) / more(13.0);
  for (const double on_a_circle : {20.0, 16.0}) {
    if (given.elements + rise * more(on_a_circle) > kFarBeyond * room) continue;
    if (Sized rounder = rounded(on_a_circle); rounder.elements <= room) return rounder;
  }
  return least;
}

/// The largest estimate allowed: where faces are many that of sizes kCoarsestScale times larger, if it is
/// more than other parts may have, up to what its faces allow.
double most_for(const Model& model, const Sized& given) {
  const double most = kShareOfMost * most_by_default(model);
  if (most <= kUsualMost || given.elements <= kUsualMost) return kUsualMost;
  const SizePlan coarser = coarsened(given.plan, kCoarsestScale);
  return std::clamp(elements_or_countless([&] { return estimated_elements(model, coarser); }), kUsualMost,
                    most);
}

}  // namespace

MeshOptions scaled_sizes(const Model& model, const MeshOptions& options, double scale) {
  MeshOptions scaled = options;
  scaled.target_elements = 0.0;
  scaled.size = scale * global_size(model, options);
  scaled.max_size = 0.0;  // in the size already
  // Counts would jump with the phase of the octants' lengths.
  scaled.suit_curvature = scaled.suit_own_sizes = false;
  scaled.region_scale *= scale;
  scaled.curvature_angle =
      std::min(scale * options.curvature_angle, std::max(options.curvature_angle, kWidestAngle));
  // Finer sizes make walls no thinner: what is asked for across them is a least number.
  scaled.wall_elements /= std::max(scale, 1.0);
  scaled.gap_elements /= std::max(scale, 1.0);
  for (SizeAttribute& attribute : scaled.attributes) {
    if (attribute.elements > 0)
      attribute.elements = std::max(1, static_cast<int>(attribute.elements / scale));
    attribute.size *= scale;
  }
  if (options.background)
    scaled.background = [field = options.background, scale](const Box3& box) { return scale * field(box); };
  return scaled;
}

double log_scale_for(const Model& model, const std::function<SizePlan(double)>& sizes, double log_elements,
                     double start, double near) {
  constexpr int kMostTrees = 8;
  double x = start, slope = kSlope, last_x = 0.0, last_y = 0.0;
  for (int i = 0; i < kMostTrees; ++i) {
    const double y = std::log(elements_or_countless([&] { return estimated_elements(model, sizes(x)); }));
    if (std::abs(y - log_elements) < near) break;
    if (i > 0 && std::abs(x - last_x) > 1e-6 && std::isfinite(y) && std::isfinite(last_y))
      slope = std::clamp((y - last_y) / (x - last_x), -4.0, -1.0);
    last_x = x;
    last_y = y;
    x += std::clamp((log_elements - y) / slope, -1.5, 1.5);
  }
  return x;
}

bool has_free_sizes(const MeshOptions& options) {
  return options.size == 0.0 && options.attributes.empty() && !options.background &&
         options.min_size == 0.0 && options.max_size == 0.0;
}

double most_by_default(const Model& model) { return kMost * std::max(1.0, model.count(2) / kManyFaces); }

MeshOptions with_default_size(const Model& model, const MeshOptions& options, SizeMemo* memo) {
  MeshOptions chosen = options;
  chosen.suit_own_sizes = options.size != 0.0;
  if (options.size != 0.0) return chosen;
  chosen.size = global_size(model, options);
  chosen.suit_curvature = true;
  if (options.small_regions) chosen.region_scale = 1.0;
  if (!has_free_sizes(options)) return chosen;
  // Whoever asks for elements across walls means them, but no mesh without a size has more elements than
  // this: sizes would grow until a 32nd of them left no more.
  if (options.wall_budget == 0.0) chosen.wall_budget = kShareOfMost * most_by_default(model);
  SizeMemo own;
  SizeMemo& known = memo != nullptr ? *memo : own;  // a circle's elements change neither walls nor gaps
  Sized first = sized(model, chosen, known);
  if (first.elements < kUsualMost && has_free_curvature(options))
    first = with_rounder_faces(model, std::move(first), known);
  const double wanted = std::clamp(first.elements, kFewest, most_for(model, first));
  if (std::abs(std::log(first.elements / wanted)) < kNear) return first.options;
  const auto sizes = [&](double log_scale) {
    MeshOptions scaled = first.options;
    scaled.size *= std::exp(log_scale);
    scaled.region_scale *= std::exp(log_scale);
    scaled.suit_curvature = false;  // as in scaled_sizes()
    return scaled;
  };
  const auto planned = [&](double log_scale) {
    return log_scale >= 0.0 ? coarsened(first.plan, std::exp(log_scale))
                            : plan_sizes(model, sizes(log_scale), &known);
  };
  return sizes(log_scale_for(model, planned, std::log(wanted), 0.0, kNear));
}

}  // namespace octet
