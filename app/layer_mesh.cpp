// SPDX-License-Identifier: BSD-3-Clause
// Words, layers, and the account of them.
#include "app/layer_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "app/entity_groups.h"
#include "app/measures.h"
#include "app/stage_clock.h"
#include "app/words.h"
#include "base/error.h"
#include "classify/acceptance.h"
#include "mesh/local_size.h"
#include "mesh/size_lookup.h"

namespace octet {
namespace {

constexpr int kMostLayers = 100;
constexpr double kMostGrowth = 3.0;

InputError layers_refusal(std::string_view text, std::string_view why) {
  return InputError(fmt::format("--layers \"{}\": {}", text, why));
}

/// 0 where the text is none.
double number_of(const std::string& text) {
  std::size_t end = 0;
  try {
    const double value = std::stod(text, &end);
    return end == text.size() && std::isfinite(value) ? value : 0.0;
  } catch (const std::exception&) {
    return 0.0;
  }
}

std::vector<double> heights_of(const LayerRequest& request) {
  std::vector<double> heights;
  double height = request.first, sum = 0.0;
  for (int i = 0; i < request.count; ++i) {
    sum += height;
    heights.push_back(sum);
    height *= request.growth;
  }
  return heights;
}

/// At most: three to each triangle of a wall and layer.
std::size_t elements_of_layers(const Mesh& mesh, const Model& model, const std::vector<LayerWish>& wishes) {
  std::vector<bool> is_wall(static_cast<std::size_t>(model.count(2)) + 1, false);
  for (const LayerWish& wish : wishes)
    for (const int face : wish.faces) is_wall[static_cast<std::size_t>(face)] = true;
  const auto triangles = static_cast<std::size_t>(
      std::count_if(mesh.triangle_on.begin(), mesh.triangle_on.end(),
                    [&](std::int32_t face) { return is_wall[static_cast<std::size_t>(face)]; }));
  return 3 * triangles * wishes.front().heights.size();
}

std::string note_of(const LayerReport& report) {
  if (report.nodes == 0)
    return "there are no layers: nowhere on the faces asked for do the elements leave room for them";
  std::string note;
  if (report.thinner > 0)
    note = fmt::format(
        "layers are thinner than asked for at {} of {} nodes of the walls, {:.2g} of it at {} where "
        "they are thinnest, for the elements beyond leave no more room: ask for a larger size or "
        "lower layers",
        report.thinner, report.nodes, report.least, place_text(report.least_at));
  if (report.bare > 0)
    note += fmt::format(
        "{}layers thin out to nothing at {} nodes of the walls: where walls of very other directions meet, "
        "an edge "
        "of theirs ends, or the elements beyond leave no room",
        note.empty() ? "" : "; ", report.bare);
  return note;
}

}  // namespace

LayerRequest parse_layers(std::string_view text, double unit) {
  LayerRequest request;
  request.text = text;
  const std::size_t equals = text.rfind('=');
  if (equals == 0 || equals == std::string_view::npos)
    throw layers_refusal(
        text, "layers are written PLACES=HEIGHT,COUNT or PLACES=HEIGHT,COUNT,GROWTH, as in Face3=0.1,5");
  std::vector<std::string> words(1);
  for (const char c : text.substr(equals + 1))
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  const double height = number_of(words[0]), count = words.size() > 1 ? number_of(words[1]) : 0.0,
               growth = words.size() > 2 ? number_of(words[2]) : request.growth;
  if (words.size() > 3 || !(height > 0.0))
    throw layers_refusal(text, "the height of the first layer must be a positive number");
  if (!(count >= 1.0 && count <= kMostLayers && count == std::floor(count)))
    throw layers_refusal(text, fmt::format("the number of layers must be 1 to {}", kMostLayers));
  if (!(growth >= 1.0 && growth <= kMostGrowth))
    throw layers_refusal(text, fmt::format("the growth of layers must be 1 to {}", kMostGrowth));
  try {
    request.places = parse_places(text.substr(0, equals), unit);
  } catch (const InputError& error) {
    throw layers_refusal(text, error.what());
  }
  request.first = height * unit;
  request.count = static_cast<int>(count);
  request.growth = growth;
  return request;
}

std::vector<LayerWish> layer_wishes(const Model& model, const std::vector<LayerRequest>& requests) {
  std::map<int, std::size_t> of_face;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const LayerRequest& request = requests[i];
    if (request.count != requests.front().count)
      throw layers_refusal(request.text, "all faces must have as many layers");
    for (const SizeAttribute& place : request.places) {
      std::vector<ModelRef> entities;
      try {
        entities = selected_entities(model, place);
      } catch (const InputError& error) {
        throw layers_refusal(request.text, error.what());
      }
      for (const ModelRef entity : entities) {
        if (entity.dim != 2)
          throw layers_refusal(request.text,
                               fmt::format("{} is no face{}", model.describe(entity),
                                           place.dim < 0 ? "; say which, as in Face:" + place.text : ""));
        const auto& sides = model.face(entity.tag).region;
        if ((sides[0] == 0) == (sides[1] == 0))
          throw layers_refusal(request.text,
                               fmt::format("{} has regions on both sides: layers go on the outside of a part",
                                           model.describe(entity)));
        of_face[entity.tag] = i;
      }
    }
  }
  std::vector<LayerWish> wishes(requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) wishes[i].heights = heights_of(requests[i]);
  for (const auto& [face, i] : of_face) wishes[i].faces.push_back(face);
  return wishes;
}

void grow_layers(MeshResult& result, const Model& model, const std::vector<LayerWish>& wishes,
                 std::size_t max_elements, const std::function<bool()>& cancelled, Observer& observer) {
  MeshReport& report = result.report;
  if (!report.faults.empty()) {
    report.notes.push_back("there are no layers, for the mesh has faults");
    return;
  }
  const std::size_t elements = result.mesh.tets.size() + elements_of_layers(result.mesh, model, wishes);
  if (elements > max_elements)
    throw LimitError(
        fmt::format("with layers there would be about {:.2g} elements, more than the limit of {}; ask "
                    "for fewer layers, or a larger size{}",
                    static_cast<double>(elements), max_elements, or_raise(max_elements)));
  StageClock clock;
  observer.stage("layers", 0.99);
  LayerOptions options;
  options.wishes = wishes;
  options.cancelled = cancelled;
  const SizeLookup sizes(result.mesh.points, vertex_sizes(result.mesh, element_edges(result.mesh)));
  options.size_at = [&](const Vec3& p) { return sizes.at(p); };
  report.layers = add_layers(result.mesh, model, options, observer);
  report.acceptance = accept_mesh(result.mesh, model);
  report.faults = faults_of(report.acceptance.claims);
  if (!report.acceptance.holds()) report.status = MeshStatus::kIncomplete;
  report.cad_volume = 0.0;  // it is summed up anew
  measure_mesh(result.mesh, model, report);
  report.quality = report.layers->beyond;
  if (std::string note = note_of(*report.layers); !note.empty()) report.notes.push_back(std::move(note));
  report.times.push_back(clock.lap("layers"));
}

}  // namespace octet
