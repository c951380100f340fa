// SPDX-License-Identifier: BSD-3-Clause
// `octet check`: the claims of docs/conventions.md about a mesh file and a part file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/apart.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/length_unit.h"
#include "app/periodic_words.h"
#include "app/reading_options.h"
#include "app/report_json.h"
#include "app/summary.h"
#include "classify/periodic.h"
#include "geom/occt/read_part.h"
#include "io/write.h"

namespace octet {
namespace {

/// How many different entities the tags name.
std::size_t entities(std::vector<std::int32_t> tags) {
  std::sort(tags.begin(), tags.end());
  return static_cast<std::size_t>(std::unique(tags.begin(), tags.end()) - tags.begin());
}

/// What tells a mesh of the part read with other options from a wrong one of this part; nothing where both
/// have as many entities.
std::string hint_of_other_options(const Mesh& mesh, const Model& model) {
  std::vector<std::int32_t> vertices;
  for (const ModelRef& on : mesh.point_on)
    if (on.dim == 0) vertices.push_back(on.tag);
  const std::array<std::size_t, 4> own{entities(std::move(vertices)), entities(mesh.edge_on),
                                       entities(mesh.triangle_on), entities(mesh.tet_in)};
  bool same = true;
  for (int dim = 0; dim <= 3; ++dim)
    same = same && own[static_cast<std::size_t>(dim)] == static_cast<std::size_t>(model.count(dim));
  if (same) return {};
  return fmt::format(
      "  hint     regions, faces, edges, vertices: {}, {}, {}, {} in the mesh and {}, {}, {}, {} in the\n"
      "           part as it was read; a mesh made with --defeature, or whose run noted that small features\n"
      "           were taken away, is checked with the same --defeature; so with --no-fuse, --sew, --cap\n",
      own[3], own[2], own[1], own[0], model.count(3), model.count(2), model.count(1), model.count(0));
}

}  // namespace

int run_check(const CheckCommand& command) {
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  const Mesh mesh = read_mesh(command.mesh, unit.millimetres);
  const Model model = read_part(command.part, in_millimetres(command.reading, unit));
  Acceptance acceptance = accept_as_meshed(mesh, model);
  std::vector<PeriodicWish> periodic;
  for (const std::string& text : command.periodic) periodic.push_back(parse_periodic(text, unit.millimetres));
  const Periodicity periodicity(model, periodic_faces(model, periodic));
  if (!periodicity.empty() && acceptance.holds("numbers"))
    acceptance.claims.push_back(match_periodic(mesh, model, periodicity).claim);
  const std::vector<Fault> beside = faults_of_part(model);
  const RunNames names{command.part.string(), command.mesh.string(), unit.name};
  if (command.json)
    fmt::print("{}", acceptance_json(names, model, acceptance, beside));
  else
    fmt::print("{} against {}\n{}", names.mesh, names.part, acceptance_summary(model, acceptance, beside));
  if (!acceptance.holds())
    fmt::print(command.json ? stderr : stdout, "{}", hint_of_other_options(mesh, model));
  return acceptance.holds() && beside.empty() ? kExitComplete : kExitIncomplete;
}

}  // namespace octet
