// SPDX-License-Identifier: BSD-3-Clause
// `octet mesh`: every cheap way to fail is tried before the part is read.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_code.h"
#include "app/mesh_request.h"
#include "app/output_check.h"
#include "app/piece_words.h"
#include "app/report_json.h"
#include "app/stage_clock.h"
#include "app/summary.h"
#include "app/usable_threads.h"
#include "io/output_file.h"
#include "io/write.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

void check_outputs(const MeshCommand& command, const std::vector<MeshFormat>& formats) {
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < formats.size(); ++i)
    for (fs::path& file : written_files(command.outputs[i], formats[i])) files.push_back(std::move(file));
  if (!command.report.empty()) files.push_back(command.report);
  if (!command.faults_piece.empty()) files.push_back(command.faults_piece);
  for (auto file = files.begin(); file != files.end(); ++file) {
    check_distinct(command.part, *file);
    for (auto before = files.begin(); before != file; ++before) check_distinct(*before, *file);
    check_writable(*file);
  }
  if (!command.dump_directory.empty()) make_directory(command.dump_directory);
}

void write_report(const fs::path& path, const std::string& text) {
  if (path.empty()) return;
  OutputFile file(path);
  file.write(text);
  file.commit();
}

ConsoleOptions console_options(const MeshCommand& command) {
  ConsoleOptions options;
  options.progress = !command.quiet && ::isatty(STDERR_FILENO) != 0;
  options.notes = command.verbose;
  options.dump_directory = command.dump_directory;
  return options;
}

/// Writes what of the part is at fault, if that was asked for, and says so. Where that cannot be done the
/// mesh, or the error that there was, is not less for it.
void write_faults(const MeshCommand& command, const MeshRequest& request,
                  const std::vector<ModelRef>& entities) {
  if (command.faults_piece.empty()) return;
  const std::string file = command.faults_piece.string();
  std::string line = fmt::format("  {} was not written: nothing of the file is at fault\n", file);
  try {
    if (!entities.empty())
      line = fmt::format("  at fault {}: {}\n", file,
                         write_piece(command.part, {entities, 1, piece_format(command.faults_piece)},
                                     request.reading, command.faults_piece));
    if (!command.quiet) fmt::print("{}", line);
  } catch (const Error& error) {
    fmt::print(stderr, "octet: {} was not written: {}\n", file, error.what());
  }
}

/// That of `octet adapt`. None where it cannot be read as a whole, for a field by the tags of its elements
/// needs less of it: then a note says that it was not held against the part.
std::optional<Mesh> solved_mesh(const fs::path& path, const LengthUnit& unit, std::string& note) {
  if (path.empty()) return std::nullopt;
  try {
    return read_mesh(path, unit.millimetres);
  } catch (const InputError& error) {
    if (!fs::exists(path)) throw;
    note = fmt::format("whether the mesh is one of this part was not asked: {}", error.what());
    return std::nullopt;
  }
}

int mesh_to_file(const MeshCommand& command, const MeshRequest& request, const RunNames& names,
                 const std::vector<MeshFormat>& formats) {
  Console console(console_options(command));
  std::string not_asked;
  const std::optional<Mesh> solved = solved_mesh(command.sizes.field_mesh, request.unit, not_asked);
  MadeMesh made = make_mesh(command.part, request, solved, console);
  const Model& model = made.model;
  MeshReport& report = made.result.report;
  if (!not_asked.empty()) report.notes.push_back(not_asked);

  StageClock clock;
  console.stage("writing", 1.0);
  WriteOptions write_options;
  write_options.scale = 1.0 / request.unit.millimetres;
  for (std::size_t i = 0; i < formats.size(); ++i)
    write_mesh(command.outputs[i], made.result.mesh, made.outline, formats[i], write_options);
  report.times.push_back(clock.lap("writing"));
  write_report(command.report, mesh_report_json(names, model, report));
  console.clear();

  if (!command.quiet)
    fmt::print("{} -> {}{} ({})\n{}", names.part, names.mesh,
               names.copies.empty() ? "" : fmt::format(", {}", fmt::join(names.copies, ", ")),
               request.unit.name, mesh_summary(model, report));
  write_faults(command, request, faults_as_read(model, report.faults));
  return report.status == MeshStatus::kComplete ? kExitComplete : kExitIncomplete;
}

}  // namespace

int run_mesh(const MeshCommand& command) {
  const MeshRequest request = request_of(command);
  if (!command.format.empty() && command.outputs.size() > 1)
    throw InputError("--format is for one output; of several, the suffix of each tells");
  std::vector<MeshFormat> formats;
  for (const fs::path& output : command.outputs) {
    formats.push_back(mesh_format(output, command.format));
    check_format(formats.back(), command.order);
  }
  if (!command.faults_piece.empty()) static_cast<void>(piece_format(command.faults_piece));
  check_outputs(command, formats);
  const tbb::global_control most_threads(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(usable_threads(request.options.threads)));
  RunNames names{command.part.string(), command.outputs.front().string(), request.unit.name};
  for (auto copy = command.outputs.begin() + 1; copy != command.outputs.end(); ++copy)
    names.copies.push_back(copy->string());
  try {
    return mesh_to_file(command, request, names, formats);
  } catch (const ModelError& error) {
    write_report(command.report, failure_json(names, error.what()));
    write_faults(command, request,
                 error.entity().valid() ? std::vector{error.entity()} : std::vector<ModelRef>{});
    throw;
  } catch (const std::exception& error) {
    write_report(command.report, failure_json(names, error.what()));
    throw;
  }
}

}  // namespace octet
