// SPDX-License-Identifier: BSD-3-Clause
// Places are those of sizes: one grammar for all that names entities.
#include "app/entity_groups.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/sort_unique.h"

namespace octet {
namespace {

bool begins_place(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '*' || c == '?' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::vector<std::string> split_places(std::string_view text) {
  std::vector<std::string> places(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',' && i + 1 < text.size() && begins_place(text[i + 1]))
      places.emplace_back();
    else
      places.back() += text[i];
  }
  return places;
}

std::vector<ModelRef> entities_at(const Model& model, const SizeAttribute& place, const GroupWords& word) {
  try {
    return selected_entities(model, place);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--group \"{}\": {}", word.text, error.what()));
  }
}

constexpr const char* kKinds[4] = {"vertices", "edges", "faces", "regions"};

}  // namespace

std::vector<SizeAttribute> parse_places(std::string_view text, double unit) {
  std::vector<SizeAttribute> places;
  for (const std::string& place : split_places(text)) {
    SizeAttribute where = parse_size_attribute(place + "=1", unit);
    if (is_shape(where.where))
      throw InputError(fmt::format("entities are asked for, and \"{}\" is a piece of space", place));
    where.text = place;
    places.push_back(std::move(where));
  }
  return places;
}

GroupWords parse_group(std::string_view text, double unit) {
  GroupWords words;
  words.text = text;
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == text.size())
    throw InputError(
        fmt::format("--group \"{}\": a group is written NAME=PLACE, as in fixed=Face1,Face7-9,bore*", text));
  words.name = text.substr(0, equals);
  try {
    words.places = parse_places(text.substr(equals + 1), unit);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--group \"{}\": {}", text, error.what()));
  }
  return words;
}

std::vector<OutlineGroup> groups_of(const Model& model, const std::vector<GroupWords>& words) {
  std::vector<OutlineGroup> groups;
  for (const GroupWords& word : words) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const OutlineGroup& known) { return known.name == word.name; });
    if (group == groups.end()) group = groups.insert(groups.end(), OutlineGroup{word.name, -1, {}});
    for (const SizeAttribute& place : word.places)
      for (const ModelRef entity : entities_at(model, place, word)) {
        if (group->dim < 0) group->dim = entity.dim;
        if (entity.dim != group->dim)
          throw InputError(fmt::format("--group \"{}\": {} would be a group of {} and {}{}", word.text,
                                       word.name, kKinds[group->dim], kKinds[entity.dim],
                                       place.dim < 0 ? "; say which, as in Face:" + place.text : ""));
        group->tags.push_back(entity.tag);
      }
    sort_unique(group->tags);
  }
  return groups;
}

}  // namespace octet
