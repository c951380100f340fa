// SPDX-License-Identifier: BSD-3-Clause
// Options with their help, and how words are parsed.
#include "app/mesh_words.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "app/config_file.h"
#include "app/reading_options.h"
#include "app/size_options.h"
#include "base/error.h"
#include "geom/closest_word.h"

namespace octet {

void add_order(CLI::App& sub, int& order, const char* none_given) {
  sub.add_option("--order", order,
                 fmt::format("Order of the elements: 1, or 2, with edges that follow the curved faces and no "
                             "element turned over (default: {})",
                             none_given))
      ->check(CLI::Range(1, 2).description(""))
      ->type_name("N");
}

void add_periodic(CLI::App& sub, std::vector<std::string>& periodic) {
  sub.add_option(
         "--periodic", periodic,
         "Faces that have the same mesh, in another place, may be repeated: x, y, z (those in the "
         "least plane across the axis and those in the greatest), or Face1,Face4=Face2,Face5 (the faces "
         "and their images under one motion, which is found); places as of --size-at")
      ->type_name("x|PLACES=PLACES")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_mesh_wishes(CLI::App& sub, MeshCommand& mesh) {
  add_size_options(sub, mesh.sizes);
  add_order(sub, mesh.order, "1");
  sub.add_option(
         "--group", mesh.groups,
         "Entities of one dimension by a name of your own, may be repeated: fixed=Face1,Face7-9,bore*; "
         "places as of --size-at. Written beside the entities' own sets and groups")
      ->type_name("NAME=PLACES")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_periodic(sub, mesh.periodic);
  sub.add_option(
         "--layers", mesh.layers,
         "Thin layers on faces, may be repeated: Face3,Face7=0.1,5 (five, the first 0.1 high, each a fifth "
         "higher than the one before) or wall*=0.1,5,1.5 (half as high again); places as of --size-at")
      ->type_name("PLACES=HEIGHT,COUNT[,GROWTH]")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  sub.add_option("--unit", mesh.unit, kUnitHelp)->type_name("UNIT");
  sub.add_option("--threads", mesh.threads,
                 "Threads, no more than cores; any number gives the same bytes (default: all cores)")
      ->type_name("N");
  sub.add_option("--max-elements", mesh.max_elements, "Refuse what needs more elements (default: 20000000)")
      ->type_name("N");
  CLI::Option* fast = sub.add_flag_callback(
      "--fast", [&mesh] { mesh.scope = FinalizeScope::kFast; },
      "One round for all elements' shapes, then the worst up to 20 degrees only");
  const std::map<std::string, FinalizeScope> scopes{{"smoothing", FinalizeScope::kSmoothing},
                                                    {"nicks", FinalizeScope::kNicks},
                                                    {"fast", FinalizeScope::kFast},
                                                    {"all", FinalizeScope::kAll}};
  sub.add_option(
         "--finalize", mesh.scope,
         "How much to do for shapes: smoothing, nicks (and short edges), fast (as --fast), all (default)")
      ->transform(CLI::CheckedTransformer(scopes).description(""))
      ->type_name("SCOPE")
      ->excludes(fast);
  sub.add_flag_callback(
      "--no-finalize", [&mesh] { mesh.finalize = false; },
      "Leave the elements' shapes as classification made them");
  add_reading_options(sub, mesh.reading);
}

/// What may have been meant by the first option that a command does not know.
std::string meant_option(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const std::string& word : command->remaining()) {
      if (word.rfind("--", 0) != 0) continue;
      std::vector<std::string> known;
      for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      const std::string close = closest_word(word.substr(0, word.find('=')), known);
      return close.empty() ? std::string() : " (did you mean " + close + "?)";
    }
  return {};
}

namespace {

void refuse_repetitions(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool once = option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw;
    if (once && !option->get_positional() && option->count() > 1)
      throw InputError(fmt::format("{} is given twice", option->get_name()));
  }
}

}  // namespace

// The command line is parsed alone first: what it says goes before what files say, and it names the files.
void parse(CLI::App& app, const std::vector<std::string>& words) {
  const auto parse_words = [&app](std::vector<std::string> all) {
    std::reverse(all.begin(), all.end());  // as the parser wants them
    app.parse(std::move(all));
  };
  std::exception_ptr failure;
  try {
    parse_words(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) throw;
    failure = std::current_exception();
  }
  const std::vector<CLI::App*> commands = app.get_subcommands();
  if (!commands.empty()) {
    refuse_repetitions(*commands.front());
    const std::vector<std::string> all = with_config(*commands.front(), words);
    if (all != words) return parse_words(all);
  }
  if (failure) std::rethrow_exception(failure);
}

namespace {

/// Of words alone: no part, no help. `add`: the options.
template <class Add>
void parse_alone(const std::vector<std::string>& words, const Add& add) {
  CLI::App app("", "octet");
  CLI::App& sub = *app.add_subcommand("mesh", "");
  app.set_help_flag();
  sub.set_help_flag();
  add(sub);
  std::vector<std::string> all{sub.get_name()};
  all.insert(all.end(), words.begin(), words.end());
  try {
    parse(app, all);
  } catch (const CLI::ParseError& error) {
    throw InputError(error.what() + meant_option(app));
  }
}

}  // namespace

MeshCommand parse_mesh_wishes(const std::vector<std::string>& words) {
  MeshCommand mesh;
  parse_alone(words, [&](CLI::App& sub) { add_mesh_wishes(sub, mesh); });
  return mesh;
}

ReadOptions parse_reading(const std::vector<std::string>& words) {
  ReadOptions reading;
  std::string unit = "mm";
  parse_alone(words, [&](CLI::App& sub) {
    add_reading_options(sub, reading);
    sub.add_option("--unit", unit, kUnitHelp);
  });
  return in_millimetres(reading, length_unit(unit));
}

}  // namespace octet
