// SPDX-License-Identifier: BSD-3-Clause
// `octet info`.
#include <fmt/format.h>

#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/info_json.h"
#include "app/info_text.h"
#include "app/own_frame.h"
#include "app/scaled_sizes.h"
#include "app/size_boxes.h"
#include "app/size_table.h"
#include "geom/occt/read_part.h"
#include "geom/size_memo.h"

namespace octet {

int run_info(const InfoCommand& command) {
  const Model model = read_part(command.part, command.reading);
  const std::string name = command.part.string();
  if (command.show_sizes) {
    MeshOptions options;
    const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
    apply_sizes(command.sizes, unit, options);
    const OwnFrame frame(model, options);
    SizeMemo memo;
    const MeshOptions sized = with_default_size(frame.model(), frame.options(), &memo);
    const SizePlan plan = plan_sizes(frame.model(), sized, &memo);
    if (!command.size_field.empty()) {
      SizeBoxes boxes = size_boxes(frame.model(), plan);
      frame.to_part(boxes.points);
      write_size_field(command.size_field, boxes, 1.0 / unit.millimetres);
    }
    fmt::print("{}", command.json ? size_table_json(name, frame.model(), plan)
                                  : size_table(name, frame.model(), plan));
    return kExitComplete;
  }
  const PartInfo info = part_info(model);
  if (command.json) {
    fmt::print("{}", part_info_json(name, model, info));
  } else {
    fmt::print("{}\n{}", name, part_text(model, info));
    if (command.entities) fmt::print("{}", entity_table(model));
  }
  return kExitComplete;
}

}  // namespace octet
