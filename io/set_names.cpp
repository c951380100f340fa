// SPDX-License-Identifier: BSD-3-Clause
// The most that every reader of decks takes.
#include "io/set_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace octet {
namespace {

char upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool is_letter(char c) { return upper_case(c) >= 'A' && upper_case(c) <= 'Z'; }

std::string set_name(const std::string& name) {
  std::string text;
  for (const char c : name) text += is_letter(c) || (c >= '0' && c <= '9') || c == '-' ? c : '_';
  return text.empty() || is_letter(text.front()) ? text : "N" + text;
}

}  // namespace

std::string entity_name(ModelRef entity) {
  constexpr const char* kKind[4] = {"Vertex", "Edge", "Face", "Solid"};
  return fmt::format("{}{}", kKind[entity.dim], entity.tag);
}

std::map<ModelRef, std::string> set_names(const ModelOutline& outline, std::size_t longest) {
  std::map<ModelRef, std::string> names;
  std::set<std::string> taken;
  const auto is_new = [&taken](std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), upper_case);
    return taken.insert(word).second;
  };
  for (int dim = 3; dim >= 0; --dim)
    for (const OutlineEntity& e : outline.entities[static_cast<std::size_t>(dim)]) {
      const std::string own = entity_name({dim, e.tag});
      const std::string given = set_name(e.name).substr(0, longest);
      std::string name = given.empty() ? own : given;
      for (std::string behind = "_" + own; !is_new(name); behind += "_" + own)
        name = given.substr(0, longest - std::min(longest, behind.size())) + behind;
      names[{dim, e.tag}] = name;
    }
  return names;
}

}  // namespace octet
