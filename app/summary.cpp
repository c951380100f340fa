// SPDX-License-Identifier: BSD-3-Clause
// One line per fact, the verdict last, where the eye is when the run ends.
#include "app/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/ids_in_file.h"
#include "app/measures.h"
#include "app/region_measures.h"
#include "app/self_contact.h"
#include "app/words.h"
#include "base/constants.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

constexpr std::size_t kShownFaults = 10;
/// Of a region's volume: what is more off than this is hardly meant.
constexpr double kFarOff = 0.05;

std::string fault_lines(const Model& model, const std::vector<Fault>& faults) {
  std::string text;
  for (std::size_t i = 0; i < faults.size() && i < kShownFaults; ++i)
    text += fmt::format("    {}\n", fault_line(model, faults[i]));
  if (faults.size() > kShownFaults)
    text += fmt::format("    and {} more (--report lists all)\n", faults.size() - kShownFaults);
  return text;
}

/// Of the size asked for: what is shorter than that is hardly worth its elements.
constexpr double kTinyShare = 0.1;

std::string shortfall_line(const Model& model, const SizeShortfall& shortfall) {
  if (shortfall.shortest.empty()) return {};
  const ShortEdge& worst = shortfall.shortest.front();
  const double tiny = 2.0 * worst.length;
  const std::size_t features = worst.length < kTinyShare * worst.asked ? features_within(model, tiny) : 0;
  const std::string advice =
      features == 0
          ? std::string()
          : fmt::format(
                " -> --defeature {:.2g} takes {} edges and faces away that are no larger, where it can", tiny,
                features);
  return fmt::format(
      "  {:<9}{} edges of the boundary are shorter than a quarter of the size asked for there: the shortest "
      "{:.3g} mm of {:.3g}, on {} at {}{}\n",
      "short", shortfall.edges, worst.length, worst.asked, model.describe(worst.entity),
      place_text(worst.place), advice);
}

/// The part's doing, and no fault: but who takes the boundary for a manifold wants to know.
std::string contact_line(const Model& model) {
  const SelfContact contact = self_contact(model);
  if (contact.edges.empty() && contact.vertices.empty()) return {};
  const std::string edges =
      contact.edges.empty() ? std::string() : " along " + tag_list("Edge", contact.edges);
  const std::string vertices =
      contact.vertices.empty() ? std::string() : " at " + tag_list("Vertex", contact.vertices);
  return fmt::format("  {:<9}itself{}{}{}: the boundary is no manifold there\n", "touches", edges,
                     edges.empty() || vertices.empty() ? "" : ", and", vertices);
}

/// What became of the wishes, and what reading changed in the part, or could not.
std::string note_lines(const Model& model, const MeshReport& report) {
  constexpr std::size_t kShownNotes = 6;
  const std::vector<std::string>& notes = model.notes();
  std::string text;
  for (const std::string& note : report.notes) text += fmt::format("  {:<9}{}\n", "note", note);
  for (std::size_t i = 0; i < std::min(kShownNotes, notes.size()); ++i)
    text += fmt::format("  {:<9}{}\n", "note", notes[i]);
  if (notes.size() > kShownNotes)
    text += fmt::format("  {:<9}and {} more (octet info lists all)\n", "note", notes.size() - kShownNotes);
  return text;
}

/// Of a mesh of second order: how far its edges follow the CAD.
std::string curve_line(const Model& model, const std::optional<CurveReport>& curve) {
  if (!curve) return {};
  std::string text = fmt::format("  {:<9}{} edges curved, scaled Jacobian at least {:.2f}", "order 2",
                                 curve->curved, curve->least_scaled_jacobian);
  if (curve->held.empty()) return text + "\n";
  const OffCad& worst = curve->held.front();
  return text + fmt::format(
                    "; {} edges nearer to straight than the CAD (elements would turn over, or the arc is too "
                    "long): {:.2g} mm "
                    "off at most, on {} at {}\n",
                    curve->held.size(), worst.distance, model.describe(worst.entity),
                    place_text(worst.place));
}

std::string layers_line(const std::optional<LayerReport>& layers) {
  return layers
             ? fmt::format("  {:<9}{} tetrahedra on {} nodes of walls; the quality is that of all others\n",
                           "layers", layers->tets, layers->nodes)
             : std::string();
}

std::string measure_line(const char* name, const char* unit, double mesh, double cad) {
  const double error = cad > 0.0 ? 100.0 * (mesh / cad - 1.0) : 0.0;
  return fmt::format("  {:<9}{:.6g} {}, CAD {:.6g} ({:+.3g} %)\n", name, mesh, unit, cad, error);
}

/// Of one region the volume of all tells it.
std::string regions_line(const Model& model, const Acceptance& acceptance) {
  const std::vector<RegionMeasure> regions = region_measures(acceptance, model);
  const RegionMeasure* region = least_alike(regions);
  if (!region || regions.size() < 2) return {};
  const std::string advice = region->volume == 0.0 || std::abs(region->relative_error()) < kFarOff
                                 ? std::string()
                                 : fmt::format(" -> --size-at Region{}={:.2g} is finer there", region->tag,
                                               size_that_rounds(model, region->tag));
  return fmt::format("  {:<9}{}, their volumes off by {:+.3g} % at most: {} {:.4g} mm^3, CAD {:.4g}{}\n",
                     "regions", regions.size(), 100.0 * region->relative_error(),
                     model.describe(model_region(region->tag)), region->volume, region->cad_volume, advice);
}

std::string distance_line(const Model& model, const std::optional<Farthest>& farthest) {
  if (!farthest) return {};
  return fmt::format("  {:<9}{:.3g} mm at most, from {} at {}\n", "distance", farthest->distance,
                     model.describe(farthest->entity), place_text(farthest->place));
}

std::string periodic_line(const std::vector<PeriodicLink>& links) {
  std::size_t faces = 0, nodes = 0;
  for (const PeriodicLink& link : links)
    if (link.entity.dim == 2) {
      ++faces;
      nodes += link.nodes.size();
    }
  if (faces == 0) return {};
  return fmt::format("  {:<9}{} {} of others, {} pairs of nodes\n", "periodic", faces,
                     faces == 1 ? "face is the image" : "faces are images", nodes);
}

std::string times_line(const std::vector<StageTime>& times) {
  double total = 0.0;
  std::string parts;
  for (const StageTime& time : times) {
    total += time.seconds;
    parts += fmt::format("{}{} {:.2f}", parts.empty() ? "" : ", ", time.name, time.seconds);
  }
  return fmt::format("  {:<9}{:.2f} s: {}\n", "time", total, parts);
}

}  // namespace

std::string fault_line(const Model& model, const Fault& fault) {
  std::string line;
  if (fault.entity.valid()) line = model.describe(fault.entity) + IdsInFile(model).text(fault.entity) + " ";
  line += fmt::format("at {}: {}", place_text(fault.place), fault.cause);
  if (!fault.advice.empty()) line += fmt::format(" -> {}", fault.advice);
  return line;
}

std::string quality_line(const char* name, const QualitySummary& q) {
  return fmt::format(
      "  {:<9}dihedral angles {:.1f} to {:.1f} degrees (99 % of elements above {:.1f}), mean ratio {:.3f} "
      "(least {:.3f})\n",
      name, q.min_dihedral * kInDegrees, q.max_dihedral * kInDegrees, q.p1_min_dihedral * kInDegrees,
      q.mean_mean_ratio, q.min_mean_ratio);
}

std::string mesh_summary(const Model& model, const MeshReport& report) {
  std::string text = fmt::format(
      "  size     {:.6g} mm{}\n", report.size,
      report.too_coarse > report.size
          ? fmt::format(" (at {:.6g} mm most of the boundary had no mesh faces)", report.too_coarse)
          : "");
  text += fmt::format("  mesh     {} tetrahedra, {} nodes, {} boundary triangles\n", report.tets,
                      report.nodes, report.triangles);
  text += shortfall_line(model, report.shortfall);
  text += quality_line("quality", report.quality);
  text += layers_line(report.layers);
  text += curve_line(model, report.curve);
  text += measure_line("volume", "mm^3", report.volume, report.cad_volume);
  text += regions_line(model, report.acceptance);
  text += measure_line("area", "mm^2", report.area, report.cad_area);
  text += distance_line(model, farthest_from_cad(report));
  text += contact_line(model);
  text += periodic_line(report.links);
  text += times_line(report.times);
  text += note_lines(model, report);
  if (!report.warnings.empty())
    text += fmt::format(
        "  warnings {}: the part is a danger to the mesh there at this size, or a wish is not met\n{}",
        report.warnings.size(), fault_lines(model, report.warnings));
  if (report.status == MeshStatus::kComplete)
    return text + fmt::format("  status   complete: all {} claims hold\n", report.acceptance.claims.size());
  text += fmt::format("  status   incomplete: {} faults\n", report.faults.size());
  return text + fault_lines(model, report.faults);
}

std::string acceptance_summary(const Model& model, const Acceptance& acceptance,
                               const std::vector<Fault>& beside) {
  std::string text;
  std::size_t broken = 0;
  for (const Claim& claim : acceptance.claims) {
    text += fmt::format("  {:<6} {}: {}", claim.holds ? "holds" : "BROKEN", claim.name, claim.statement);
    if (claim.worst != 0.0 || claim.limit != 0.0)
      text += fmt::format(" (worst {:.3g}, limit {:.3g})", claim.worst, claim.limit);
    text += "\n";
    if (!claim.holds) text += fault_lines(model, claim.faults);
    broken += claim.holds ? 0 : 1;
  }
  const std::string claims =
      broken == 0 ? fmt::format("all {} claims hold", acceptance.claims.size())
                  : fmt::format("{} of {} claims are broken", broken, acceptance.claims.size());
  if (beside.empty())
    return text + fmt::format("  status   {}: {}\n", broken == 0 ? "complete" : "incomplete", claims);
  text += fmt::format("  status   incomplete: {}, and of the part\n", claims);
  return text + fault_lines(model, beside);
}

}  // namespace octet
