// SPDX-License-Identifier: BSD-3-Clause
// What a file says becomes words of the command line, so that one parser judges both.
#include "app/config_file.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/json.h"
#include "base/error.h"
#include "geom/closest_word.h"

namespace octet {
namespace {

constexpr const char* kPlaces = "size-at";  // the one option whose value may be an object

/// A key of a file and its values; booleans are the words true and false.
struct Setting {
  std::string key;
  std::vector<std::string> values;
  bool is_list = false, is_boolean = false;
};

std::string word_of(const std::string& key, const Json& value) {
  if (value.is_null() || value.is_structured() || (value.is_string() && value.get<std::string>().empty()))
    throw InputError(fmt::format("\"{}\" has no value that an option may have: {}", key, value.dump()));
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Setting json_setting(const std::string& key, const Json& value) {
  Setting setting{key, {}, value.is_array() || value.is_object(), value.is_boolean()};
  if (value.is_object() && key == kPlaces) {
    for (const auto& [place, size] : value.items())
      setting.values.push_back(fmt::format("{}={}", place, word_of(key, size)));
  } else if (value.is_array()) {
    for (const Json& item : value) setting.values.push_back(word_of(key, item));
  } else {
    setting.values.push_back(word_of(key, value));
  }
  return setting;
}

/// With an error for equal keys, of which JSON itself lets the last stand.
Json parsed(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  const auto look = [&keys](int, Json::parse_event_t event, const Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw InputError(fmt::format("\"{}\" stands in it twice", value.get<std::string>()));
    return true;
  };
  return Json::parse(text, look);
}

std::vector<Setting> json_settings(const std::string& text) {
  std::vector<Setting> settings;
  const Json json = parsed(text);
  for (const auto& [key, value] : json.items()) settings.push_back(json_setting(key, value));
  return settings;
}

/// The key below its table, without quotes.
std::string place_of(const CLI::ConfigItem& item) {
  std::string place;
  for (std::size_t i = 1; i < item.parents.size(); ++i) place += item.parents[i] + ".";
  place += item.name;
  std::erase(place, '"');
  return place;
}

Setting toml_setting(const CLI::ConfigItem& item) {
  if (item.inputs.empty() || item.inputs.front().empty())
    throw InputError(fmt::format("\"{}\" has no value", item.fullname()));
  if (item.parents.empty()) {
    const bool boolean = item.inputs.front() == "true" || item.inputs.front() == "false";
    return {item.name, item.inputs, item.inputs.size() > 1, boolean};
  }
  // A table is the other way to write places and sizes: [size-at] with lines Face12 = 0.5. The parser
  // takes the points of a quoted place for those between tables.
  Setting setting{item.parents.front(), {}, true, false};
  if (setting.key != kPlaces) throw InputError(fmt::format("\"{}\" may not be a table", setting.key));
  for (const std::string& input : item.inputs)
    setting.values.push_back(fmt::format("{}={}", place_of(item), input));
  return setting;
}

std::vector<Setting> toml_settings(const std::string& text) {
  std::istringstream in(text);
  std::vector<Setting> settings;
  std::set<std::string> names;
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(in)) {
    if (item.name == "--") continue;  // a table ends
    if (item.name == "++") {
      if (item.parents.front() != kPlaces)
        throw InputError(fmt::format("\"{}\" may not be a table", item.parents.front()));
      continue;
    }
    if (!names.insert(item.fullname()).second)
      throw InputError(fmt::format("\"{}\" stands in it twice", item.fullname()));
    settings.push_back(toml_setting(item));
  }
  return settings;
}

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r';
  });
}

/// Whether each line that is no comment could be one of a TOML file that has options, tables and lists.
bool may_be_toml(const std::string& text) {
  std::istringstream in(text);
  bool in_list = false;
  for (std::string line; std::getline(in, line);) {
    CLI::detail::trim(line);
    if (line.empty() || line.front() == '#') continue;
    const bool opens = line.find('[') != std::string::npos, closes = line.find(']') != std::string::npos;
    if (!in_list && line.front() != '[' && (line.find('=') == std::string::npos || line.front() == '='))
      return false;
    in_list = (in_list || opens) && !closes;
  }
  return true;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
    throw InputError(fmt::format("cannot read \"{}\": it is missing, empty or not readable", path));
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string bytes = text.str();
  if (bytes.starts_with(kByteOrderMark)) bytes.erase(0, kByteOrderMark.size());
  return bytes;
}

std::vector<Setting> settings_of(const std::string& path) {
  const std::string text = bytes_of(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = Json::accept(text) || (first != std::string::npos && text[first] == '{');
  if (!is_text(text) || (json && text[first] != '{') || (!json && !may_be_toml(text)))
    throw InputError(fmt::format("\"{}\" is not a JSON object of options ({{\"size\": 2}}), nor TOML", path));
  try {
    return json ? json_settings(text) : toml_settings(text);
  } catch (const Json::exception& error) {
    const std::string_view what = error.what();  // "[json.exception....] parse error at ..."
    throw InputError(
        fmt::format("\"{}\" is not a JSON object of options: {}", path, what.substr(what.find("] ") + 2)));
  } catch (const std::exception& error) {
    throw InputError(fmt::format("cannot read \"{}\": {}", path, error.what()));
  }
}

std::string name_of(const CLI::Option& option) { return "--" + option.get_lnames().front(); }

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

bool may_be_repeated(const CLI::Option& option) {
  return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

/// The option that a setting is of, where its values fit; InputError otherwise.
const CLI::Option& option_of(const CLI::App& command, const Setting& setting) {
  const std::string name = "--" + setting.key;
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr) {
    std::vector<std::string> known;
    for (const CLI::Option* one : command.get_options())
      if (one->get_configurable() && !one->get_lnames().empty()) known.push_back(name_of(*one));
    const std::string close = closest_word(name, known);
    throw InputError(fmt::format("\"{}\" is no option of octet {}{}", setting.key, command.get_name(),
                                 close.empty() ? "" : fmt::format(" (did you mean {}?)", close)));
  }
  if (!option->get_configurable()) throw InputError(fmt::format("\"{}\" may not stand in it", setting.key));
  if (setting.is_list && !may_be_repeated(*option))
    throw InputError(fmt::format("\"{}\" takes one value", setting.key));
  if (setting.is_boolean != is_flag(*option))
    throw InputError(fmt::format("\"{}\" takes {}", setting.key,
                                 is_flag(*option) ? "true or false" : "a value, not true or false"));
  return *option;
}

std::string place_in(const std::string& wish) { return wish.substr(0, wish.rfind('=')); }

/// What has been said with more weight than what comes next.
struct Said {
  std::set<const CLI::Option*> options;
  std::set<std::string> places;

  [[nodiscard]] bool has(const CLI::Option& option) const {
    const std::set<CLI::Option*> others = option.get_excludes();
    return options.count(&option) > 0 || std::any_of(others.begin(), others.end(), [&](CLI::Option* other) {
             return options.count(other) > 0;
           });
  }
};

std::vector<std::string> words_of(const CLI::App& command, const std::string& path, Said& said) {
  std::vector<std::string> words;
  Said own;
  for (const Setting& setting : settings_of(path)) {
    try {
      const CLI::Option& option = option_of(command, setting);
      const bool places = setting.key == kPlaces;
      own.options.insert(&option);
      for (const std::string& value : setting.values) {
        if (places) own.places.insert(place_in(value));
        const bool off = is_flag(option) && value == "false";
        if (off || (places ? said.places.count(place_in(value)) > 0 : said.has(option))) continue;
        words.push_back(fmt::format("{}={}", name_of(option), value));
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("cannot read \"{}\": {}", path, error.what()));
    }
  }
  said.options.merge(own.options);
  said.places.merge(own.places);
  return words;
}

}  // namespace

std::vector<std::string> with_config(const CLI::App& command, const std::vector<std::string>& arguments) {
  const CLI::Option* config = command.get_option_no_throw(kConfig);
  if (config == nullptr) return arguments;
  Said said;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0) said.options.insert(option);
  if (const CLI::Option* places = command.get_option_no_throw(std::string("--") + kPlaces))
    for (const std::string& wish : places->results()) said.places.insert(place_in(wish));
  std::vector<std::string> found;
  const std::vector<std::string> paths = config->results();
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    const std::vector<std::string> words = words_of(command, *path, said);
    found.insert(found.begin(), words.begin(), words.end());
  }
  std::vector<std::string> all = arguments;
  const auto name = std::find(all.begin(), all.end(), command.get_name());
  all.insert(name == all.end() ? name : name + 1, found.begin(), found.end());
  return all;
}

}  // namespace octet
