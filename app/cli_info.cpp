// SPDX-License-Identifier: BSD-3-Clause
// `octet info`.
#include <fmt/format.h>

#include <cstdio>

#include "app/at_place.h"
#include "app/commands.h"
#include "app/entity_shapes.h"
#include "app/entity_table.h"
#include "app/exit_code.h"
#include "app/info_json.h"
#include "app/info_text.h"
#include "app/output_check.h"
#include "app/own_frame.h"
#include "app/reading_options.h"
#include "app/scaled_sizes.h"
#include "app/size_boxes.h"
#include "app/size_notes.h"
#include "app/size_table.h"
#include "app/suited_octants.h"
#include "geom/occt/read_part.h"
#include "geom/size_memo.h"

namespace octet {

namespace {

void print_sizes(const InfoCommand& command, const Model& model, const LengthUnit& unit) {
  const std::string name = command.part.string();
  MeshOptions options;
  apply_sizes(command.sizes, unit, options);
  const OwnFrame frame(model, options);
  SizeMemo memo;
  const MeshOptions sized = with_default_size(frame.model(), frame.options(), &memo);
  SizePlan plan = plan_sizes(frame.model(), sized, &memo);
  const std::string suited = suit_octants(frame.model(), sized, plan);
  if (!command.size_field.empty()) {
    SizeBoxes boxes = size_boxes(frame.model(), plan);
    frame.to_part(boxes.points);
    write_size_field(command.size_field, boxes, 1.0 / unit.millimetres);
  }
  std::vector<std::string> notes = size_notes(model, options);
  if (!suited.empty()) notes.push_back(suited);
  fmt::print("{}", command.json ? size_table_json(name, frame.model(), plan, notes)
                                : size_table(name, frame.model(), plan, notes));
}

void print_part(const InfoCommand& command, const Model& model, const std::vector<Vec3>& places) {
  const std::string name = command.part.string();
  const bool is_table = command.entities || !places.empty();
  const EntityShapes shapes = command.json || is_table ? entity_shapes(model) : EntityShapes{};
  std::vector<AtPlace> at;
  for (const Vec3& place : places) at.push_back(at_place(model, place));
  if (command.json) {
    fmt::print("{}", part_info_json(name, model, part_info(model), shapes, at));
    return;
  }
  fmt::print("{}\n", name);
  if (places.empty() || command.entities) fmt::print("{}", part_text(model, part_info(model)));
  if (command.entities) fmt::print("{}", entity_table(model, shapes));
  for (const AtPlace& place : at) fmt::print("{}", place_lines(model, shapes, place));
}

}  // namespace

int run_info(const InfoCommand& command) {
  if (!command.size_field.empty()) {
    if (command.size_field.extension() != ".vtu")
      throw InputError(
          fmt::format("--write-field writes VTU: \"{}\" must end in .vtu", command.size_field.string()));
    check_writable(command.size_field);
  }
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  std::vector<Vec3> places;
  for (const std::string& text : command.at) places.push_back(parse_place(text, unit.millimetres));
  const Model model = read_part(command.part, in_millimetres(command.reading, unit));
  if (command.show_sizes)
    print_sizes(command, model, unit);
  else
    print_part(command, model, places);
  return kExitComplete;
}

}  // namespace octet
