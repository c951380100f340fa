// SPDX-License-Identifier: BSD-3-Clause
// `octet extract`.
#include <fmt/format.h>

#include "app/commands.h"
#include "app/entity_groups.h"
#include "app/exit_code.h"
#include "app/length_unit.h"
#include "app/output_check.h"
#include "app/piece_words.h"
#include "app/reading_options.h"
#include "base/error.h"

namespace octet {

int run_extract(const ExtractCommand& command) {
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  PieceWish wish;
  wish.format = piece_format(command.output);
  if (command.around < 0) throw InputError("--around must be at least 0");
  wish.around = command.around;
  std::vector<SizeAttribute> places;
  for (const std::string& text : command.places)
    for (SizeAttribute& place : parse_places(text, unit.millimetres)) places.push_back(std::move(place));
  check_distinct(command.part, command.output);
  check_writable(command.output);
  const ReadOptions reading = in_millimetres(command.reading, unit);
  wish.entities = places_as_read(command.part, places, reading);
  if (wish.entities.empty())
    throw InputError(
        "nothing in the file is what these places name: the faces of caps are in the model alone");
  const std::string text = write_piece(command.part, wish, reading, command.output);
  if (!command.quiet) fmt::print("{} -> {}: {}\n", command.part.string(), command.output.string(), text);
  return kExitComplete;
}

}  // namespace octet
