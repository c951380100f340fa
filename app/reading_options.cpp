// SPDX-License-Identifier: BSD-3-Clause
// How a part is read, as options of every command that reads one.
#include "app/reading_options.h"

#include <CLI/CLI.hpp>

namespace octet {

void add_reading_options(CLI::App& command, ReadOptions& reading) {
  CLI::Option* apart = command.add_flag_callback(
      "--no-fuse", [&reading] { reading.fuse = false; },
      "Keep solids that touch apart: they share no faces, and their meshes do not fit");
  command
      .add_option("--fuse-tolerance", reading.fuse_tolerance,
                  "Solids that overlap, or miss each other, by no more than this distance touch (default: "
                  "what rounding leaves, 1e-6 of their diagonal)")
      ->type_name("LENGTH")
      ->check(CLI::PositiveNumber)
      ->excludes(apart);
  command
      .add_option(
          "--sew", reading.sew_tolerance,
          "Sew loose faces and open solids within this distance (default: the least that closes them, "
          "up to 1e-4 of their diagonal)")
      ->type_name("LENGTH")
      ->check(CLI::PositiveNumber);
  command.add_flag("--cap", reading.cap,
                   "Close openings of shells and open solids that lie in a plane by a plane face each, and "
                   "list them (default: such parts are refused)");
  command
      .add_flag(
          "--embed", reading.embed,
          "Loose faces, as baffles and cracks are drawn, become part of the solids that they lie in, and "
          "the mesh follows them (default: they are left out, and listed; faces that the file itself has "
          "within a solid are always followed)")
      ->excludes(apart);
  command
      .add_option(
          "--defeature", reading.smallest_feature,
          "Take away edges shorter, and faces, spikes and slits narrower than this where the part "
          "stays closed and keeps its volume to a twentieth, and list them (default: what rounding leaves; "
          "if a mesh has faults, or only one of far too many elements might have none, also what is "
          "below the accuracy that the STEP file states, or far below the size)")
      ->type_name("LENGTH")
      ->check(CLI::PositiveNumber);
  command
      .add_option(
          "--read-time-limit", reading.time_limit,
          "Refuse a part whose reading takes more seconds, or, if that is for fusing its solids, read them "
          "apart, which is a fault; 0: no limit (default: 300)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 1e9));
  const auto set_memory = [&reading](double gigabytes) {
    constexpr double kGigabyte = 1e9;
    reading.memory_limit = static_cast<std::size_t>(gigabytes * kGigabyte);
  };
  command
      .add_option_function<double>("--read-memory-limit", set_memory,
                                   "Refuse a part whose reading needs more memory, or read its solids apart, "
                                   "as above (default: half of "
                                   "the machine's)")
      ->type_name("GB")
      ->check(CLI::Range(1e-3, 1e9));
}

ReadOptions in_millimetres(ReadOptions reading, const LengthUnit& unit) {
  for (double* length : {&reading.fuse_tolerance, &reading.sew_tolerance, &reading.smallest_feature})
    *length *= unit.millimetres;
  return reading;
}

}  // namespace octet
