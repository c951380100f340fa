// SPDX-License-Identifier: BSD-3-Clause
// The most that every reader of decks takes.
#include "io/set_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/entity_words.h"

namespace octet {
namespace {

char upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string upper_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](char c) { return upper_case(c); });
  return word;
}

bool is_letter(char c) { return upper_case(c) >= 'A' && upper_case(c) <= 'Z'; }

std::string set_name(const std::string& name) {
  std::string text;
  for (const char c : name) text += is_letter(c) || (c >= '0' && c <= '9') || c == '-' ? c : '_';
  return text.empty() || is_letter(text.front()) ? text : "N" + text;
}

}  // namespace

std::string entity_name(ModelRef entity) { return fmt::format("{}{}", shape_word(entity.dim), entity.tag); }

SetNames set_names(const ModelOutline& outline, std::size_t longest) {
  constexpr const char* kKinds[4] = {"Vertices", "Edges", "Faces", "Solids"};
  SetNames names;
  std::set<std::string> taken;
  const auto is_new = [&taken](const std::string& word) { return taken.insert(upper_case(word)).second; };
  /// The word, with as much of `behind` as makes it new.
  const auto unique = [&](const std::string& word, const std::string& behind) {
    std::string name = word;
    for (std::string end = behind; !is_new(name); end += behind)
      name = word.substr(0, longest - std::min(longest, end.size())) + end;
    return name;
  };
  for (const OutlineGroup& group : outline.groups)
    names.shared.push_back(
        {unique(set_name(group.name).substr(0, longest), "_group"), group.dim, group.tags});
  for (int dim = 3; dim >= 0; --dim) {
    const auto& entities = outline.entities[static_cast<std::size_t>(dim)];
    std::map<std::string, std::vector<const OutlineEntity*>> bearers;  // by the name in upper case
    for (const OutlineEntity& e : entities)
      if (!e.name.empty()) bearers[upper_case(set_name(e.name).substr(0, longest))].push_back(&e);
    for (const auto& [word, all] : bearers) {
      if (all.size() < 2) continue;
      OutlineGroup set{
          unique(set_name(all.front()->name).substr(0, longest), fmt::format("_{}", kKinds[dim])), dim, {}};
      for (const OutlineEntity* e : all) set.tags.push_back(e->tag);
      names.shared.push_back(std::move(set));
    }
    for (const OutlineEntity& e : entities) {
      const std::string own = entity_name({dim, e.tag});
      const std::string given = set_name(e.name).substr(0, longest);
      names.of[{dim, e.tag}] = unique(given.empty() ? own : given, "_" + own);
    }
  }
  return names;
}

}  // namespace octet
