// SPDX-License-Identifier: BSD-3-Clause
// The smallest sample of each entity speaks for it.
#include "app/size_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/element_estimate.h"
#include "app/octant_sizes.h"
#include "app/words.h"

namespace octet {
namespace {

struct EntitySize {
  double size = kNoSize;  ///< asked for
  SizeReason why = SizeReason::kGlobal;
  double gets = kNoSize;  ///< of the powers of two that the octants offer
};

const char* reason_name(SizeReason why) {
  switch (why) {
    case SizeReason::kGlobal:
      return "global";
    case SizeReason::kAttribute:
      return "asked for";
    case SizeReason::kShortEdge:
      return "short edge";
    case SizeReason::kEdgeGap:
      return "near edge";
    case SizeReason::kCurvature:
      return "curvature";
    case SizeReason::kWall:
      return "wall";
    case SizeReason::kSmallRegion:
      return "small region";
    default:
      return "gap";
  }
}

std::map<ModelRef, EntitySize> entity_sizes(const SizePlan& plan) {
  std::map<ModelRef, EntitySize> sizes;
  const OctreeRequest request = octant_request(plan);
  const auto given = [&](double octant) {
    return kEdgePerOctant * request.size * std::exp2(-std::ceil(std::log2(request.size / octant) - 1e-6));
  };
  const std::vector<SizeSample> octants = octant_samples(plan);
  for (std::size_t i = 0; i < octants.size(); ++i) {
    const SizeSample& sample = plan.samples[i];
    EntitySize& entity = sizes[sample.on];
    if (sample.size < entity.size) entity = {sample.size, sample.why, given(octants[i].size)};
  }
  for (std::size_t r = 1; r < plan.region_size.size(); ++r)
    if (plan.region_size[r] < kNoSize)
      sizes[model_region(static_cast<int>(r))] = {plan.region_size[r], plan.region_why[r],
                                                  given(request.region_size[r])};
  return sizes;
}

}  // namespace

std::string size_table(const std::string& part, const Model& model, const SizePlan& plan,
                       const std::vector<std::string>& notes) {
  const double elements = estimated_elements(model, planned_octree(model, plan));
  std::string text =
      fmt::format("{}\n  about {} tetrahedra, with edges of {:.4g} mm ({:.4g} asked for)\n", part,
                  about_text(elements), kEdgePerOctant * octant_request(plan).size, plan.asked);
  const auto sizes = entity_sizes(plan);
  if (!sizes.empty()) text += fmt::format("    {:<24} {:>10}    {:>10}\n", "but for", "asked for", "gets");
  for (const auto& [entity, size] : sizes)
    text += fmt::format("    {:<24} {:>10.4g} mm {:>10.4g} mm  {}\n", model.describe(entity), size.size,
                        size.gets, reason_name(size.why));
  if (plan.field) text += "    and shapes or fields over space\n";
  for (const std::string& note : notes) text += fmt::format("  note     {}\n", note);
  return text;
}

std::string size_table_json(const std::string& part, const Model& model, const SizePlan& plan,
                            const std::vector<std::string>& notes) {
  nlohmann::ordered_json json{{"part", part},
                              {"size", plan.asked},
                              {"edges", kEdgePerOctant * octant_request(plan).size},
                              {"min_size", plan.min_size}};
  json["estimated_elements"] = estimated_elements(model, planned_octree(model, plan));
  json["entities"] = nlohmann::ordered_json::array();
  for (const auto& [entity, size] : entity_sizes(plan))
    json["entities"].push_back({{"dim", entity.dim},
                                {"tag", entity.tag},
                                {"entity", model.describe(entity)},
                                {"size", size.size},
                                {"gets", size.gets},
                                {"why", reason_name(size.why)}});
  json["notes"] = notes;
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace octet
