// SPDX-License-Identifier: BSD-3-Clause
// The command line: parse, run, and turn every way to end into one exit code and one line.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_code.h"
#include "app/failure.h"
#include "app/heap.h"
#include "app/mesh_words.h"
#include "app/reading_options.h"
#include "app/size_options.h"
#include "base/error.h"
#include "geom/closest_word.h"
#include "io/write.h"

namespace octet {
namespace {

constexpr const char* kFooter =
    "Lengths on the command line and coordinates of mesh files are in --unit (default: mm);\n"
    "what is printed, advice included, is in mm and degrees.\n"
    "\n"
    "Exit codes:\n"
    "  0  complete: the mesh was written (mesh) or read (check) and every claim about it holds\n"
    "  2  bad input or use: the part, an option, a limit or the output path; no file was written\n"
    "  3  incomplete: the mesh was written or read, and the faults listed remain\n"
    "  4  failed: no mesh; cancelled, out of memory, or a defect of octet\n";

int complain(const std::string& message, ExitCode code) {
  std::string line = message;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  while (!line.empty() && line.back() == ' ') line.pop_back();
  std::fprintf(stderr, "octet: error: %s\n", line.c_str());
  return code;
}

template <class Run>
int guarded(const Run& run) {
  try {
    const int code = run();
    // What was printed may sit in a buffer that a full disk or a closed pipe cannot take.
    if (std::fflush(stdout) != 0) return complain("cannot write to standard output", kExitBadInput);
    return code;
  } catch (...) {
    const Failure failure = failure_of(std::current_exception());
    return complain(failure.text, failure.code);
  }
}

/// What `mesh` and `adapt` have alike.
void add_meshing(CLI::App& sub, MeshCommand& mesh) {
  sub.add_option(
         "-o,--output", mesh.outputs,
         fmt::format("Mesh file to write ({}), may be repeated: the same mesh in each", mesh_suffixes()))
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  sub.add_option("--format", mesh.format, mesh_format_names() + " (default: by suffix)")->type_name("FORMAT");
  add_mesh_wishes(sub, mesh);
  sub.add_option("--report", mesh.report, "Write a report as JSON")->type_name("FILE");
  sub.add_option(
         "--write-faults", mesh.faults_piece,
         "Where the part or its mesh has faults, write the faces at fault and those around them, as the "
         "file has them (.brep, .step)")
      ->type_name("FILE");
  sub.add_option("--dump-stages", mesh.dump_directory, "Write the mesh of every stage into this directory")
      ->type_name("DIR");
  CLI::Option* quiet = sub.add_flag("--quiet,-q", mesh.quiet, "Print nothing but errors");
  sub.add_flag("--verbose,-v", mesh.verbose, "Tell of every stage on stderr")->excludes(quiet);
  sub.footer(kFooter);
}

void add_mesh(CLI::App& app, MeshCommand& mesh) {
  CLI::App& sub = *app.add_subcommand("mesh", "Mesh a CAD part: classified tetrahedra");
  sub.add_option("part", mesh.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  add_meshing(sub, mesh);
}

void add_adapt(CLI::App& app, MeshCommand& adapt) {
  CLI::App& sub =
      *app.add_subcommand("adapt", "Mesh a part anew, with the sizes that an error estimate wants");
  sub.add_option("mesh", adapt.sizes.field_mesh, "The mesh that was solved on: MSH or VTU")
      ->required()
      ->type_name("FILE");
  sub.add_option("part", adapt.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  add_meshing(sub, adapt);
  sub.get_option("--field")->required()->description(
      "Sizes wanted: CSV with one size a line, for each tetrahedron or each node of the mesh in its order; "
      "or as for octet mesh");
  adapt.sizes.size_of_field = true;
}

void add_info(CLI::App& app, InfoCommand& info) {
  CLI::App& sub = *app.add_subcommand("info", "Tell what a part is: unit, size, entities, names, faults");
  sub.add_option("part", info.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  sub.add_flag("--json", info.json, "Print JSON, with every entity");
  sub.add_flag("--entities", info.entities,
               "Print a line for every entity, too: measure, centre, normal, radius, axis, ends");
  CLI::Option* at =
      sub.add_option("--at", info.at,
                     "Tell what is at a place, may be repeated: the nearest face, edge and vertex and the "
                     "region around, instead of the part (with --json or --entities: besides)")
          ->type_name("X,Y,Z")
          ->allow_extra_args(false)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* sizes =
      sub.add_flag("--sizes", info.show_sizes,
                   "Print the size that each entity gets from the options of sizes, and why, instead")
          ->excludes(at);
  const std::size_t others = sub.get_options().size();
  sub.add_option("--write-field", info.size_field, "Write the sizes over space (.vtu)")->type_name("FILE");
  add_size_options(sub, info.sizes);
  // Not `needs`, which the help would repeat for each.
  const std::vector<CLI::Option*> all = sub.get_options();
  const std::vector<CLI::Option*> of_sizes(all.begin() + static_cast<std::ptrdiff_t>(others), all.end());
  for (CLI::Option* option : of_sizes) option->group("With --sizes");
  sub.parse_complete_callback([sizes, of_sizes] {
    for (const CLI::Option* option : of_sizes) {
      if (option->count() > 0 && sizes->count() == 0) throw CLI::RequiresError(option->get_name(), "--sizes");
    }
  });
  sub.add_option("--unit", info.unit, std::string("Unit of the lengths that are given: ") + kUnitHelp)
      ->type_name("UNIT");
  add_reading_options(sub, info.reading);
  sub.footer(kFooter);
}

void add_check(CLI::App& app, CheckCommand& check) {
  CLI::App& sub = *app.add_subcommand("check", "Check a mesh against its part, claim by claim");
  sub.add_option("mesh", check.mesh, "MSH or VTU file")->required()->type_name("FILE");
  sub.add_option("part", check.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  sub.add_option("--unit", check.unit, std::string("Unit of the mesh file: ") + kUnitHelp)->type_name("UNIT");
  sub.add_flag("--json", check.json, "Print JSON");
  add_periodic(sub, check.periodic);
  add_reading_options(sub, check.reading);
  sub.footer(kFooter);
}

void add_extract(CLI::App& app, ExtractCommand& extract) {
  CLI::App& sub = *app.add_subcommand(
      "extract", "Write some faces of a part, as its file has them: to look at, to send on");
  sub.add_option("part", extract.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  sub.add_option("places", extract.places,
                 "Faces, those that edges or vertices lie on, or solids: Face12, Edge3-7, Region2, Face%12 "
                 "(number in "
                 "the file), Face%#4711 (what the file calls it), Face:name*, Face@x,y,z")
      ->required()
      ->type_name("PLACE");
  sub.add_option("-o,--output", extract.output,
                 "File to write: .brep, or .step, where faces are named, and red if asked for")
      ->required()
      ->type_name("FILE");
  sub.add_option("--around", extract.around,
                 "How often the faces that touch those are taken, too (default: 1)")
      ->type_name("N");
  sub.add_option("--unit", extract.unit, std::string("Unit of the lengths that are given: ") + kUnitHelp)
      ->type_name("UNIT");
  sub.add_flag("--quiet,-q", extract.quiet, "Print nothing but errors");
  add_reading_options(sub, extract.reading);
  sub.footer(kFooter);
}

void add_quality(CLI::App& app, QualityCommand& quality) {
  CLI::App& sub =
      *app.add_subcommand("quality", "Tell the shapes of a mesh's elements: table, histograms, worst");
  sub.add_option("mesh", quality.mesh, "MSH or VTU file")->required()->type_name("FILE");
  sub.add_option("--size", quality.size,
                 "Hold edges and walls against this size (default: that of the mesh around)")
      ->type_name("LENGTH");
  sub.add_option("--field", quality.field,
                 "Or against sizes over space, as octet info --sizes --write-field and octet adapt have them")
      ->type_name("FILE")
      ->excludes("--size");
  sub.add_option("--unit", quality.unit, std::string("Unit of the mesh file: ") + kUnitHelp)
      ->type_name("UNIT");
  sub.add_option("--worst", quality.worst, "How many of the worst elements to list (default: 10)")
      ->type_name("N");
  CLI::Option* json = sub.add_flag("--json", quality.json, "Print JSON");
  sub.add_flag("--csv", quality.csv, "Print the histograms as CSV")->excludes(json);
  sub.footer(kFooter);
}

void add_improve(CLI::App& app, ImproveCommand& improve) {
  CLI::App& sub =
      *app.add_subcommand("improve", "Better shapes for a classified mesh of the part, from any mesher");
  sub.add_option("mesh", improve.mesh, "MSH or VTU file")->required()->type_name("FILE");
  sub.add_option("part", improve.part, "STEP, IGES or BREP file")->required()->type_name("FILE");
  sub.add_option("-o,--output", improve.output, fmt::format("Mesh file to write ({})", mesh_suffixes()))
      ->required()
      ->type_name("FILE");
  sub.add_option("--size", improve.size, "Edge length wished for everywhere (default: as the mesh is around)")
      ->type_name("LENGTH");
  sub.add_option("--unit", improve.unit, std::string("Unit of the mesh files: ") + kUnitHelp)
      ->type_name("UNIT");
  sub.add_option("--format", improve.format, mesh_format_names() + " (default: by suffix)")
      ->type_name("FORMAT");
  add_order(sub, improve.order, "the mesh's");
  sub.add_option("--threads", improve.threads,
                 "Threads, no more than cores; any number gives the same bytes (default: all cores)")
      ->type_name("N");
  sub.add_option("--report", improve.report, "Write a report as JSON")->type_name("FILE");
  CLI::Option* quiet = sub.add_flag("--quiet,-q", improve.quiet, "Print nothing but errors");
  sub.add_flag("--verbose,-v", improve.verbose, "Tell of every stage on stderr")->excludes(quiet);
  add_reading_options(sub, improve.reading);
  sub.footer(kFooter);
}

/// What may have been meant by a first word that is no command: one of like spelling, or to mesh that file.
std::string meant_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(command->get_name());
  std::string close = closest_word(word, known);
  std::error_code unreadable;
  if (close.empty() && std::filesystem::is_regular_file(word, unreadable)) close = "mesh " + word;
  return close.empty() ? close : " (did you mean octet " + close + "?)";
}

int run(int argc, char** argv) {
  CLI::App app("Octet: CAD part in, classified tetrahedral mesh out", "octet");
  app.set_version_flag("--version", std::string("octet ") + OCTET_VERSION);
  app.footer(kFooter);
  app.require_subcommand(1);
  MeshCommand mesh, adapt;
  InfoCommand info;
  CheckCommand check;
  ExtractCommand extract;
  QualityCommand quality;
  ImproveCommand improve;
  add_mesh(app, mesh);
  add_adapt(app, adapt);
  add_info(app, info);
  add_check(app, check);
  add_extract(app, extract);
  add_quality(app, quality);
  add_improve(app, improve);
  try {
    parse(app, {argv + 1, argv + argc});
  } catch (const Error& error) {
    return complain(error.what(), kExitBadInput);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    const auto commands = app.get_subcommands();
    const std::string meant = !commands.empty() ? meant_option(app)
                              : argc > 1        ? meant_command(app, argv[1])
                                                : std::string();
    const std::string page = commands.empty() ? "octet" : "octet " + commands.front()->get_name();
    return complain(fmt::format("{}{}; see {} --help", error.what(), meant, page), kExitBadInput);
  }
  if (app.got_subcommand("mesh")) return guarded([&] { return run_mesh(mesh); });
  if (app.got_subcommand("adapt")) return guarded([&] { return run_mesh(adapt); });
  if (app.got_subcommand("info")) return guarded([&] { return run_info(info); });
  if (app.got_subcommand("extract")) return guarded([&] { return run_extract(extract); });
  if (app.got_subcommand("improve")) return guarded([&] { return run_improve(improve); });
  if (app.got_subcommand("quality")) return guarded([&] { return run_quality(quality); });
  return guarded([&] { return run_check(check); });
}

}  // namespace
}  // namespace octet

int main(int argc, char** argv) {
  octet::ignore_file_size_signal();
  octet::set_up_heap();
  return octet::run(argc, argv);
}
