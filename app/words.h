// SPDX-License-Identifier: BSD-3-Clause
// Places and lists in the program's words.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "base/vec.h"

namespace octet {

inline std::string place_text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

/// "Edge3, Edge7": the first ten, and how many more there are.
template <class Tags>
std::string tag_list(const char* prefix, const Tags& tags) {
  constexpr std::size_t kShown = 10;
  std::string text;
  for (std::size_t i = 0; i < tags.size() && i < kShown; ++i)
    text += fmt::format("{}{}{}", i == 0 ? "" : ", ", prefix, tags[i]);
  if (tags.size() > kShown) text += fmt::format(" and {} more", tags.size() - kShown);
  return text;
}

}  // namespace octet
