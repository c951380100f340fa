// SPDX-License-Identifier: BSD-3-Clause
// Places and the like as users write them.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace octet {

/// Finite numbers between commas; nothing when the text is anything else.
[[nodiscard]] inline std::optional<std::vector<double>> number_list(std::string_view text) {
  std::vector<double> values;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const char* const end = text.data() + comma;
    double value = 0.0;
    const auto [rest, error] = std::from_chars(text.data() + at, end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    at = comma + 1;
  }
  return values;
}

}  // namespace octet
