// SPDX-License-Identifier: BSD-3-Clause
// The options of sizes, once for every command that has them.
#include "app/size_options.h"

#include <CLI/CLI.hpp>

#include "app/config_file.h"

namespace octet {

void add_size_options(CLI::App& command, SizeWords& words) {
  const auto number = [&](const char* name, auto& value, const char* help, const char* type) {
    command.add_option(name, value, help)->type_name(type);
  };
  number("--size", words.size, "Edge length of the elements (default: from the part's dimensions)", "LENGTH");
  number("--min-size", words.min_size,
         "Refine no further than this (default: size / 32, less only where the mesh would have holes)",
         "LENGTH");
  number("--max-size", words.max_size, "No size is larger than this, wherever it comes from", "LENGTH");
  number("--target-elements", words.target_elements, "Scale the sizes to get about so many tetrahedra", "N");
  command
      .add_option(
          "--size-at", words.size_at,
          "A size at a place, may be repeated: Face12=0.5, Edge3-7=0.5, Region2=3, Face%12=0.5 (number in "
          "the file), Face%#4711=0.5 (what a STEP file calls it), Face:bore*=0.5, Face#ff0000=1, "
          "Face@x,y,z=0.5 "
          "(nearest), box:x,y,z,x,y,z=1, "
          "ball:x,y,z,r=1, cylinder:x,y,z,x,y,z,r=1, Edge5=/12 (twelve elements)")
      ->type_name("PLACE=LENGTH")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option(
          "--field", words.fields,
          "Sizes over space, may be repeated: CSV lines x,y,z,size, or an MSH or VTU file with sizes of its "
          "elements or nodes")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  number(
      "--curvature", words.curvature,
      "Elements on a full circle, or the angle of one as 20deg; 0: off (default: 11; up to 20 where no size "
      "is asked for and it costs little)",
      "N");
  number("--wall-elements", words.wall_elements, "Elements across walls; 0: off (default: 1)", "N");
  number("--gap-elements", words.gap_elements,
         "Elements across gaps and between near edges; 0: off (default: 1)", "N");
  number("--growth", words.growth, "Largest ratio of neighbouring sizes, above 1 and up to 2 (default: 2)",
         "G");
  command.add_flag("--uniform", words.uniform, "The size everywhere: nothing finer for the part's own sake");
  command
      .add_option(
          kConfig,
          "Options from a JSON or TOML file, in the same words: {\"size\": 2}; the command line prevails")
      ->type_name("FILE")
      ->configurable(false)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace octet
