// SPDX-License-Identifier: BSD-3-Clause
// Words to options, and options to a mesh.
#include "app/mesh_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "app/layer_mesh.h"
#include "app/outline.h"
#include "app/periodic_words.h"
#include "app/reading_options.h"
#include "app/same_part.h"
#include "base/error.h"

namespace octet {
namespace {

std::size_t element_limit(double value) {
  if (!std::isfinite(value) || value < 1.0)
    throw InputError(fmt::format("--max-elements must be at least 1, not {}", value));
  if (value > static_cast<double>(kMostElements))
    throw InputError(fmt::format("--max-elements may be {} at most, not {}", kMostElements, value));
  return static_cast<std::size_t>(value);
}

MeshOptions mesh_options(const MeshCommand& command, const LengthUnit& unit) {
  MeshOptions options;
  apply_sizes(command.sizes, unit, options);
  if (command.max_elements) options.max_elements = element_limit(*command.max_elements);
  options.threads =
      command.threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  if (options.threads < 1)
    throw InputError(fmt::format("--threads must be at least 1, not {}", options.threads));
  options.finalize = command.finalize;
  options.scope = command.scope;
  options.order = command.order;
  for (const std::string& text : command.periodic)
    options.periodic.push_back(parse_periodic(text, unit.millimetres));
  for (const std::string& text : command.layers)
    options.layers.push_back(parse_layers(text, unit.millimetres));
  return options;
}

}  // namespace

MeshRequest request_of(const MeshCommand& command) {
  MeshRequest request;
  request.unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  request.options = mesh_options(command, request.unit);
  request.reading = in_millimetres(command.reading, request.unit);
  for (const std::string& text : command.groups)
    request.groups.push_back(parse_group(text, request.unit.millimetres));
  return request;
}

MadeMesh make_mesh(const std::filesystem::path& part, const MeshRequest& request,
                   const std::optional<Mesh>& solved, Observer& observer) {
  const auto mesh = [&](const Model& model, LargeMesh large_mesh) {
    if (solved) require_mesh_of(*solved, model);
    static_cast<void>(groups_of(model, request.groups));  // what is nowhere is told before the work
    MeshOptions own = request.options;
    own.large_mesh = large_mesh;
    return mesh_part(model, own, observer);
  };
  MeshedFile made = mesh_file(part, request.reading, mesh, observer);
  ModelOutline outline = outline_of(made.model);
  outline.groups = groups_of(made.model, request.groups);
  outline.links = made.result.report.links;
  return {std::move(made.model), std::move(made.result), std::move(outline)};
}

}  // namespace octet
