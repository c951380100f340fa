// SPDX-License-Identifier: BSD-3-Clause
// Options from the command line and from files are parsed by the same parser.
#include "app/size_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace octet {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kConfig = "--config";

std::string word_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void add_argument(const std::string& key, const Json& value, std::vector<std::string>& arguments) {
  if (value.is_array()) {
    for (const Json& item : value) add_argument(key, item, arguments);
  } else if (value.is_object()) {
    for (const auto& [place, size] : value.items())
      arguments.push_back(fmt::format("--{}={}={}", key, place, word_of(size)));
  } else if (value.is_boolean()) {
    if (value.get<bool>()) arguments.push_back("--" + key);
  } else {
    arguments.push_back(fmt::format("--{}={}", key, word_of(value)));
  }
}

std::vector<std::string> json_arguments(const std::string& text) {
  const Json json = Json::parse(text);
  if (!json.is_object()) throw InputError("it is no JSON object");
  std::vector<std::string> arguments;
  for (const auto& [key, value] : json.items()) add_argument(key, value, arguments);
  return arguments;
}

/// The key below its table, without quotes.
std::string place_of(const CLI::ConfigItem& item) {
  std::string place;
  for (std::size_t i = 1; i < item.parents.size(); ++i) place += item.parents[i] + ".";
  place += item.name;
  std::erase(place, '"');
  return place;
}

std::vector<std::string> toml_arguments(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> arguments;
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(in)) {
    if (item.name == "++" || item.name == "--") continue;  // a section begins or ends
    if (item.inputs.empty() || item.inputs.front().empty())
      throw InputError(fmt::format("\"{}\" has no value", item.fullname()));
    for (const std::string& input : item.inputs) {
      // A table is the other way to write places and sizes: [size-at] with lines Face12 = 0.5. The parser
      // takes the points of a quoted place for those between tables.
      std::string key = item.name, value = input;
      if (!item.parents.empty()) {
        key = item.parents.front();
        value = fmt::format("{}={}", place_of(item), input);
      }
      if (input == "true")
        arguments.push_back("--" + key);
      else if (input != "false")
        arguments.push_back(fmt::format("--{}={}", key, value));
    }
  }
  return arguments;
}

std::vector<std::string> arguments_of_file(const std::string& path) {
  try {
    std::ifstream file(path);
    std::stringstream text;
    if (!file || !(text << file.rdbuf())) throw InputError("it is missing, empty or not readable");
    const std::string words = text.str();
    const std::size_t first = words.find_first_not_of(" \t\r\n");
    return first != std::string::npos && words[first] == '{' ? json_arguments(words) : toml_arguments(words);
  } catch (const std::exception& error) {
    throw InputError(fmt::format("cannot read \"{}\": {}", path, error.what()));
  }
}

}  // namespace

void add_size_options(CLI::App& command, SizeWords& words) {
  const auto last = CLI::MultiOptionPolicy::TakeLast;
  const auto number = [&](const char* name, auto& value, const char* help, const char* type) {
    command.add_option(name, value, help)->type_name(type)->multi_option_policy(last);
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
          "the file), Face:bore*=0.5, Face#ff0000=1, Face@x,y,z=0.5 (nearest), box:x,y,z,x,y,z=1, "
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
  number("--growth", words.growth, "Largest ratio of neighbouring sizes, 1 to 2 (default: 2)", "G");
  command.add_flag("--uniform", words.uniform, "The size everywhere: nothing finer for the part's own sake");
  command
      .add_option(
          kConfig,
          "Options from a JSON or TOML file, in the same words: {\"size\": 2}; the command line prevails")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<std::string> with_config(const std::vector<std::string>& arguments) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    std::string path;
    if (word == kConfig && i + 1 < arguments.size()) path = arguments[i + 1];
    if (word.rfind(std::string(kConfig) + "=", 0) == 0) path = word.substr(std::string(kConfig).size() + 1);
    if (path.empty()) continue;
    for (std::string& argument : arguments_of_file(path)) found.push_back(std::move(argument));
  }
  std::vector<std::string> all = arguments;
  if (!all.empty()) all.insert(all.begin() + 1, found.begin(), found.end());  // after the command's name
  return all;
}

}  // namespace octet
