// SPDX-License-Identifier: BSD-3-Clause
// `octet info`.
#include <fmt/format.h>

#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/info_json.h"
#include "app/info_text.h"
#include "geom/occt/read_part.h"

namespace octet {

int run_info(const InfoCommand& command) {
  const Model model = read_part(command.part, command.reading);
  const PartInfo info = part_info(model);
  const std::string name = command.part.string();
  if (command.json) {
    fmt::print("{}", part_info_json(name, model, info));
  } else {
    fmt::print("{}\n{}", name, part_text(model, info));
    if (command.entities) fmt::print("{}", entity_table(model));
  }
  return kExitComplete;
}

}  // namespace octet
