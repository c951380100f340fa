// SPDX-License-Identifier: BSD-3-Clause
// `octet improve`: better shapes for a classified mesh from anywhere.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_code.h"
#include "app/improve_mesh.h"
#include "app/length_unit.h"
#include "app/outline.h"
#include "app/output_check.h"
#include "app/reading_options.h"
#include "app/report_json.h"
#include "app/stage_clock.h"
#include "app/summary.h"
#include "app/usable_threads.h"
#include "base/error.h"
#include "geom/occt/read_part.h"
#include "io/output_file.h"
#include "io/write.h"

namespace octet {
namespace {

ImproveOptions improve_options(const ImproveCommand& command, const LengthUnit& unit) {
  ImproveOptions options;
  if (command.size) {
    if (!std::isfinite(*command.size) || *command.size <= 0.0)
      throw InputError(fmt::format("--size must be a positive length, not {}", *command.size));
    options.size = *command.size * unit.millimetres;
  }
  options.order = command.order;
  options.threads =
      command.threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  if (options.threads < 1)
    throw InputError(fmt::format("--threads must be at least 1, not {}", options.threads));
  return options;
}

}  // namespace

int run_improve(const ImproveCommand& command) {
  const LengthUnit unit = length_unit(command.unit.empty() ? "mm" : command.unit);
  const ImproveOptions options = improve_options(command, unit);
  const MeshFormat format = mesh_format(command.output, command.format);
  check_format(format, command.order);
  for (const std::filesystem::path& file : written_files(command.output, format)) check_writable(file);
  if (!command.report.empty()) check_writable(command.report);
  ConsoleOptions console_options;
  console_options.progress = !command.quiet && ::isatty(STDERR_FILENO) != 0;
  console_options.notes = command.verbose;
  Console console(console_options);
  const tbb::global_control most_threads(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(usable_threads(options.threads)));
  Mesh mesh = read_mesh(command.mesh, unit.millimetres);
  const Model model = read_part(command.part, in_millimetres(command.reading, unit));
  for (const std::string& note : model.notes()) console.note(note);

  const QualitySummary before = quality_summary(mesh);
  const MeshResult result = improve_mesh(std::move(mesh), model, options, console);
  WriteOptions write_options;
  write_options.scale = 1.0 / unit.millimetres;
  write_mesh(command.output, result.mesh, outline_of(model), format, write_options);
  const RunNames names{command.part.string(), command.output.string(), unit.name};
  if (!command.report.empty()) {
    OutputFile file(command.report);
    file.write(mesh_report_json(names, model, result.report));
    file.commit();
  }
  console.clear();
  if (!command.quiet)
    fmt::print("{} -> {} ({})\n{}{}", command.mesh.string(), names.mesh, unit.name,
               quality_line("before", before), mesh_summary(model, result.report));
  return result.report.status == MeshStatus::kComplete ? kExitComplete : kExitIncomplete;
}

}  // namespace octet
