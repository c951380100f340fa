// SPDX-License-Identifier: BSD-3-Clause
// The smallest sample of each entity speaks for it.
#include "app/size_table.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "app/element_estimate.h"

namespace octet {
namespace {

struct EntitySize {
  double size = kNoSize;
  SizeReason why = SizeReason::kGlobal;
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
    default:
      return "gap";
  }
}

std::map<ModelRef, EntitySize> entity_sizes(const SizePlan& plan) {
  std::map<ModelRef, EntitySize> sizes;
  for (const SizeSample& sample : plan.samples) {
    EntitySize& entity = sizes[sample.on];
    if (sample.size < entity.size) entity = {sample.size, sample.why};
  }
  for (std::size_t r = 1; r < plan.region_size.size(); ++r)
    if (plan.region_size[r] < kNoSize)
      sizes[model_region(static_cast<int>(r))] = {plan.region_size[r], SizeReason::kAttribute};
  return sizes;
}

}  // namespace

std::string size_table(const std::string& part, const Model& model, const SizePlan& plan) {
  std::string text = fmt::format("{}\n  size {:.6g} mm everywhere, but for\n", part, plan.asked);
  for (const auto& [entity, size] : entity_sizes(plan))
    text += fmt::format("    {:<24} {:>10.4g} mm  {}\n", model.describe(entity), size.size,
                        reason_name(size.why));
  text += fmt::format("  about {:.2g} tetrahedra\n", estimated_elements(model, plan));
  if (plan.field) text += "    and shapes or fields over space\n";
  return text;
}

std::string size_table_json(const std::string& part, const Model& model, const SizePlan& plan) {
  nlohmann::ordered_json json{{"part", part}, {"size", plan.asked}, {"min_size", plan.min_size}};
  json["estimated_elements"] = estimated_elements(model, plan);
  json["entities"] = nlohmann::ordered_json::array();
  for (const auto& [entity, size] : entity_sizes(plan))
    json["entities"].push_back({{"dim", entity.dim},
                                {"tag", entity.tag},
                                {"entity", model.describe(entity)},
                                {"size", size.size},
                                {"why", reason_name(size.why)}});
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace octet
