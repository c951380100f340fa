// SPDX-License-Identifier: BSD-3-Clause
// Places and lists in the program's words.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/vec.h"

namespace octet {

inline std::string place_text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

/// An estimate, by its first two digits: "1400".
inline std::string about_text(double number) {
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(number, 10.0))) - 1.0);
  return fmt::format("{:.0f}", digit * std::round(number / digit));
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
