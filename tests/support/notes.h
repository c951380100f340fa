// SPDX-License-Identifier: BSD-3-Clause
// What a reading tells of a part.
#pragma once

#include <string>
#include <string_view>

#include "geom/model.h"

namespace octet::test {

/// The first note that holds the words; empty where none does.
inline std::string note_with(const Model& model, std::string_view words) {
  for (const std::string& note : model.notes())
    if (note.find(words) != std::string::npos) return note;
  return {};
}

inline bool has_note(const Model& model, std::string_view words) { return !note_with(model, words).empty(); }

}  // namespace octet::test
