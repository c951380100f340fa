// SPDX-License-Identifier: BSD-3-Clause
// `octet check`: the claims of docs/conventions.md about a mesh file and a part file.
#include <fmt/format.h>

#include <cstdio>

#include "app/apart.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/length_unit.h"
#include "app/report_json.h"
#include "app/summary.h"
#include "geom/occt/read_part.h"
#include "io/write.h"

namespace octet {

int run_check(const CheckCommand& command) {
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  const Mesh mesh = read_mesh(command.mesh, unit.millimetres);
  const Model model = read_part(command.part, command.reading);
  const Acceptance acceptance = is_meshed_apart(model) ? accept_apart(mesh, model) : accept_mesh(mesh, model);
  const RunNames names{command.part.string(), command.mesh.string(), unit.name};
  if (command.json)
    fmt::print("{}", acceptance_json(names, model, acceptance));
  else
    fmt::print("{} against {}\n{}", names.mesh, names.part, acceptance_summary(model, acceptance));
  return acceptance.holds() ? kExitComplete : kExitIncomplete;
}

}  // namespace octet
