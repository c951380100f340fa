// SPDX-License-Identifier: BSD-3-Clause
// What a misspelt word was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace octet {

/// The candidate that differs from the word in the fewest characters put in, left out or changed, upper and
/// lower case being the same; the first of equally near ones. Empty where all differ in more than a third of
/// the word and one more.
[[nodiscard]] std::string closest_word(std::string_view word, std::span<const std::string> candidates);

}  // namespace octet
