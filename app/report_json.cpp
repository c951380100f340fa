// SPDX-License-Identifier: BSD-3-Clause
// Keys are stable: tests/corpus.py and users' scripts read them.
#include "app/report_json.h"

#include <algorithm>
#include <cmath>

#include "app/changed_numbers.h"
#include "app/ids_in_file.h"
#include "app/json.h"
#include "app/measures.h"
#include "app/region_measures.h"
#include "app/self_contact.h"
#include "base/constants.h"

namespace octet {
namespace {

/// Names come from CAD files in any encoding: what is no UTF-8 is replaced, never thrown at.
std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json fault_json(const Model& model, const IdsInFile& ids, const Fault& fault) {
  Json json{{"dim", fault.entity.dim}, {"tag", fault.entity.tag}};
  json["entity"] = fault.entity.valid() ? model.describe(fault.entity) : "";
  json["ids"] = ids.of(fault.entity);
  json["place"] = vec_json(fault.place);
  json["cause"] = fault.cause;
  json["advice"] = fault.advice;
  return json;
}

Json faults_json(const Model& model, const std::vector<Fault>& faults) {
  Json json = Json::array();
  if (faults.empty()) return json;
  const IdsInFile ids(model);
  for (const Fault& fault : faults) json.push_back(fault_json(model, ids, fault));
  return json;
}

Json claims_json(const Model& model, const Acceptance& acceptance) {
  Json json = Json::array();
  for (const Claim& claim : acceptance.claims)
    json.push_back({{"name", claim.name},
                    {"statement", claim.statement},
                    {"holds", claim.holds},
                    {"worst", claim.worst},
                    {"limit", claim.limit},
                    {"faults", faults_json(model, claim.faults)}});
  return json;
}

Json measure_json(double mesh, double cad) {
  return {{"mesh", mesh}, {"cad", cad}, {"relative_error", cad > 0.0 ? mesh / cad - 1.0 : 0.0}};
}

Json head_json(const RunNames& names, const char* status) {
  Json json{{"octet", OCTET_VERSION}, {"status", status}, {"part", names.part}, {"mesh", names.mesh}};
  if (!names.copies.empty()) json["copies"] = names.copies;
  json["mesh_unit"] = names.mesh_unit;
  return json;
}

Json quality_json(const QualitySummary& quality) {
  return {{"min_dihedral", quality.min_dihedral * kInDegrees},
          {"max_dihedral", quality.max_dihedral * kInDegrees},
          {"p1_min_dihedral", quality.p1_min_dihedral * kInDegrees},
          {"min_mean_ratio", quality.min_mean_ratio},
          {"mean_mean_ratio", quality.mean_mean_ratio}};
}

Json shortfall_json(const Model& model, const SizeShortfall& shortfall) {
  Json worst = Json::array();
  for (const ShortEdge& edge : shortfall.shortest)
    worst.push_back({{"dim", edge.entity.dim},
                     {"tag", edge.entity.tag},
                     {"entity", model.describe(edge.entity)},
                     {"place", vec_json(edge.place)},
                     {"length", edge.length},
                     {"asked", edge.asked}});
  return {{"edges", shortfall.edges}, {"worst", worst}};
}

Json curve_json(const Model& model, const CurveReport& curve) {
  constexpr std::size_t kListed = 10;
  Json held = Json::array();
  for (std::size_t i = 0; i < std::min(kListed, curve.held.size()); ++i) {
    const OffCad& edge = curve.held[i];
    held.push_back({{"dim", edge.entity.dim},
                    {"tag", edge.entity.tag},
                    {"entity", model.describe(edge.entity)},
                    {"place", vec_json(edge.place)},
                    {"distance", edge.distance}});
  }
  return {{"curved_edges", curve.curved},
          {"held_edges", curve.held.size()},
          {"farthest_held", held},
          {"least_scaled_jacobian", curve.least_scaled_jacobian}};
}

Json layers_json(const LayerReport& layers) {
  return {{"tets", layers.tets}, {"wall_nodes", layers.nodes},  {"thinner", layers.thinner},
          {"bare", layers.bare}, {"least_share", layers.least}, {"place", vec_json(layers.least_at)}};
}

Json regions_json(const Model& model, const Acceptance& acceptance) {
  Json json = Json::array();
  for (const RegionMeasure& region : region_measures(acceptance, model))
    json.push_back({{"tag", region.tag},
                    {"entity", model.describe(model_region(region.tag))},
                    {"volume", measure_json(region.volume, region.cad_volume)}});
  return json;
}

/// Nodes by their numbers in mesh files; motions in millimetre.
Json periodic_json(const Model& model, const std::vector<PeriodicLink>& links) {
  Json json = Json::array();
  for (const PeriodicLink& link : links) {
    Json nodes = Json::array();
    for (const auto& [node, source] : link.nodes) nodes.push_back({node + 1, source + 1});
    json.push_back({{"dim", link.entity.dim},
                    {"tag", link.entity.tag},
                    {"entity", model.describe(link.entity)},
                    {"source", link.source.tag},
                    {"motion", link.motion},
                    {"nodes", nodes}});
  }
  return json;
}

Json renumbered_json(const Model& model) {
  Json json = Json::array();
  for (const NumberChange& change : changed_numbers(model.provenance()))
    json.push_back({{"dim", change.as_read.dim}, {"as_read", change.as_read.tag}, {"tags", change.tags}});
  return json;
}

}  // namespace

std::string mesh_report_json(const RunNames& names, const Model& model, const MeshReport& report) {
  Json json = head_json(names, report.status == MeshStatus::kComplete ? "complete" : "incomplete");
  json["part_unit"] = model.unit();
  json["size"] = report.size;
  if (report.too_coarse > report.size) json["too_coarse_size"] = report.too_coarse;
  if (report.target_elements > 0.0) json["target_elements"] = report.target_elements;
  json["diagonal"] = model.diagonal();
  json["nodes"] = report.nodes;
  json["tets"] = report.tets;
  json["triangles"] = report.triangles;
  json["order"] = report.curve ? 2 : 1;
  json["template_tets"] = report.template_tets;
  json["attribute_points"] = report.attribute_points;
  json["rounds"] = report.rounds;
  json["shorter_than_asked"] = shortfall_json(model, report.shortfall);
  json["quality"] = quality_json(report.quality);
  if (report.layers) json["layers"] = layers_json(*report.layers);
  if (report.curve) json["second_order"] = curve_json(model, *report.curve);
  json["volume"] = measure_json(report.volume, report.cad_volume);
  json["regions"] = regions_json(model, report.acceptance);
  json["area"] = measure_json(report.area, report.cad_area);
  json["area"]["faces_relative_error"] = report.cad_area > 0.0 ? report.area_off / report.cad_area : 0.0;
  if (const auto farthest = farthest_from_cad(report))
    json["distance"] = {{"largest", farthest->distance},
                        {"entity", model.describe(farthest->entity)},
                        {"dim", farthest->entity.dim},
                        {"tag", farthest->entity.tag},
                        {"place", vec_json(farthest->place)}};
  const SelfContact contact = self_contact(model);
  json["touches_itself"] = {{"edges", contact.edges}, {"vertices", contact.vertices}};
  if (!report.links.empty()) json["periodic"] = periodic_json(model, report.links);
  json["renumbered"] = renumbered_json(model);
  json["times"] = Json::array();
  for (const StageTime& time : report.times)
    json["times"].push_back({{"stage", time.name},
                             {"seconds", time.seconds},
                             {"cpu_seconds", time.cpu_seconds},
                             {"peak_bytes", time.peak_bytes}});
  json["notes"] = report.notes;
  for (const std::string& note : model.notes()) json["notes"].push_back(note);
  json["faults"] = faults_json(model, report.faults);
  json["warnings"] = faults_json(model, report.warnings);
  json["claims"] = claims_json(model, report.acceptance);
  return text_of(json);
}

std::string failure_json(const RunNames& names, const std::string& message) {
  Json json = head_json(names, "failed");
  json["error"] = message;
  return text_of(json);
}

std::string acceptance_json(const RunNames& names, const Model& model, const Acceptance& acceptance,
                            const std::vector<Fault>& beside) {
  Json json = head_json(names, acceptance.holds() && beside.empty() ? "complete" : "incomplete");
  json["faults"] = faults_json(model, beside);
  json["claims"] = claims_json(model, acceptance);
  return text_of(json);
}

}  // namespace octet
