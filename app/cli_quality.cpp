// SPDX-License-Identifier: BSD-3-Clause
// `octet quality`: the shapes of a mesh file's elements as a table, histograms, JSON or CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/json.h"
#include "app/length_unit.h"
#include "app/words.h"
#include "base/constants.h"
#include "base/entity_words.h"
#include "base/error.h"
#include "io/size_file.h"
#include "io/write.h"
#include "mesh/background.h"
#include "mesh/local_size.h"
#include "mesh/quality_table.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

double told(const Distribution& d, double value) { return d.angle ? value * kInDegrees : value; }

std::string entity_name(ModelRef on) {
  return fmt::format("{}{}", entity_word(std::clamp(on.dim, 0, 3)), on.tag);
}

std::string row(const Distribution& d) {
  const auto cell = [&](double value) { return fmt::format("{:9.{}f}", told(d, value), d.angle ? 2 : 3); };
  return fmt::format("  {:<20}{}{}{}{}{}{}\n", d.name, cell(d.least), cell(d.p1), cell(d.median),
                     cell(d.mean), cell(d.p99), cell(d.largest));
}

std::string table_text(const std::vector<Distribution>& distributions) {
  std::string text = fmt::format("  {:<20}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "", "least", "1 %", "median",
                                 "mean", "99 %", "largest");
  for (const Distribution& d : distributions) text += row(d);
  return text;
}

std::string histogram_text(const Distribution& d) {
  constexpr double kWidest = 50.0;
  std::string text = fmt::format("\n  {}{}\n", d.name, d.angle ? ", degrees" : "");
  const std::size_t most = *std::max_element(d.bins.begin(), d.bins.end());
  std::size_t first = 0, last = d.bins.size();
  while (first < last && d.bins[first] == 0) ++first;
  while (last > first && d.bins[last - 1] == 0) --last;
  for (std::size_t i = first; i < last; ++i) {
    const double lo = told(d, d.lo + static_cast<double>(i) * d.width);
    const double share = static_cast<double>(d.bins[i]) / static_cast<double>(most);
    // Nothing that is there vanishes: one element is one mark at least.
    const auto marks = static_cast<std::size_t>(std::ceil(kWidest * share));
    text += fmt::format("  {:>6.{}f} {:>9} {}\n", lo, d.angle ? 0 : 2, d.bins[i], std::string(marks, '#'));
  }
  return text;
}

std::string worst_text(const QualityTable& table) {
  std::string text = "\n  worst elements (numbers from 1; angles in degrees, places in mm)\n";
  for (const WorstTet& worst : table.worst) {
    std::string on;
    for (const ModelRef entity : worst.on) on.append(" ").append(entity_name(entity));
    text += fmt::format("  {:>9}  dihedrals {:6.2f} to {:6.2f}, mean ratio {:.3f}, at {}:{}{}\n",
                        worst.tet + 1, worst.dihedral.smallest * kInDegrees,
                        worst.dihedral.largest * kInDegrees, worst.mean_ratio, place_text(worst.place), on,
                        worst.limited ? " (limited by the part)" : "");
  }
  return text;
}

std::string quality_text(const std::string& name, const QualityTable& table) {
  std::string text = fmt::format("{}: {} tetrahedra\n{}", name, table.tets, table_text(table.all));
  text += row(table.edges);
  if (table.limited > 0 && table.limited < table.tets) {
    text += fmt::format("\n  without the {} elements at sharp angles and walls thinner than one element\n{}",
                        table.limited, table_text(table.free));
  }
  for (const Distribution& d : table.all) text += histogram_text(d);
  return text + histogram_text(table.edges) + worst_text(table);
}

Json distribution_json(const Distribution& d) {
  return {{"name", d.name},
          {"unit", d.angle ? "degree" : "1"},
          {"count", d.count},
          {"least", told(d, d.least)},
          {"p1", told(d, d.p1)},
          {"median", told(d, d.median)},
          {"mean", told(d, d.mean)},
          {"p99", told(d, d.p99)},
          {"largest", told(d, d.largest)},
          {"histogram", {{"from", told(d, d.lo)}, {"width", told(d, d.width)}, {"counts", d.bins}}}};
}

Json distributions_json(const std::vector<Distribution>& distributions) {
  Json json = Json::array();
  for (const Distribution& d : distributions) json.push_back(distribution_json(d));
  return json;
}

std::string quality_json(const std::string& name, const QualityTable& table) {
  Json json{
      {"octet", OCTET_VERSION}, {"mesh", name}, {"tets", table.tets}, {"limited_by_part", table.limited}};
  json["all"] = distributions_json(table.all);
  json["without_limited"] = distributions_json(table.free);
  json["edges"] = distribution_json(table.edges);
  json["worst"] = Json::array();
  for (const WorstTet& worst : table.worst) {
    Json on = Json::array();
    for (const ModelRef entity : worst.on) on.push_back({{"dim", entity.dim}, {"tag", entity.tag}});
    json["worst"].push_back({{"element", worst.tet + 1},
                             {"min_dihedral", worst.dihedral.smallest * kInDegrees},
                             {"max_dihedral", worst.dihedral.largest * kInDegrees},
                             {"mean_ratio", worst.mean_ratio},
                             {"place", {worst.place.x(), worst.place.y(), worst.place.z()}},
                             {"on", on},
                             {"limited_by_part", worst.limited}});
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// One line per bin: measure, over what, from, to, count.
std::string quality_csv(const QualityTable& table) {
  std::string text = "measure,over,from,to,count\n";
  const auto add = [&](const Distribution& d, const char* over) {
    for (std::size_t i = 0; i < d.bins.size(); ++i) {
      const double lo = d.lo + static_cast<double>(i) * d.width;
      text += fmt::format("{},{},{:.6g},{:.6g},{}\n", d.name, over, told(d, lo), told(d, lo + d.width),
                          d.bins[i]);
    }
  };
  for (const Distribution& d : table.all) add(d, "all");
  for (const Distribution& d : table.free) add(d, "without limited");
  add(table.edges, "all");
  return text;
}

/// Per vertex; where a field says nothing, the mesh speaks for itself.
std::vector<double> sizes_asked_for(const QualityCommand& command, const Mesh& mesh, const LengthUnit& unit) {
  if (command.size) return std::vector<double>(mesh.points.size(), *command.size * unit.millimetres);
  std::vector<double> sizes = vertex_sizes(mesh, element_edges(mesh));
  if (command.field.empty()) return sizes;
  const SizeField field =
      background_field(scaled(read_size_file(command.field, command.mesh), unit.millimetres));
  for (std::size_t v = 0; v < sizes.size(); ++v) {
    // A cloud of the middles of boxes ends half a box before these do.
    const Box3 at{mesh.points[v], mesh.points[v]};
    double size = field(at);
    if (size == kNoSize) size = field(at.grown(sizes[v]));
    if (size < kNoSize) sizes[v] = size;
  }
  return sizes;
}

}  // namespace

int run_quality(const QualityCommand& command) {
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  if (command.size && !(*command.size > 0.0 && std::isfinite(*command.size)))
    throw InputError(fmt::format("the size must be a positive number, not {}", *command.size));
  const Mesh mesh = read_mesh(command.mesh, unit.millimetres);
  const std::string name = command.mesh.string();
  if (mesh.tets.empty()) throw InputError(name + " has no tetrahedra");
  if (const std::string fault = check_mesh_soundness(mesh); !fault.empty())
    throw InputError(fmt::format("{} is no sound classified mesh: {}", name, fault));
  const std::vector<double> size = sizes_asked_for(command, mesh, unit);
  const QualityTable table = quality_table(mesh, size, command.worst);
  if (command.json)
    fmt::print("{}", quality_json(name, table));
  else if (command.csv)
    fmt::print("{}", quality_csv(table));
  else
    fmt::print("{}", quality_text(name, table));
  return kExitComplete;
}

}  // namespace octet
