// SPDX-License-Identifier: BSD-3-Clause
// The size that each entity of the part gets, and why, before anything is meshed.
#pragma once

#include <string>
#include <vector>

#include "geom/size_plan.h"

namespace octet {

/// One line per entity that is finer than the rest, for people; and the notes (app/size_notes.h). Lengths in
/// millimetre.
[[nodiscard]] std::string size_table(const std::string& part, const Model& model, const SizePlan& plan,
                                     const std::vector<std::string>& notes);
/// The same as JSON.
[[nodiscard]] std::string size_table_json(const std::string& part, const Model& model, const SizePlan& plan,
                                          const std::vector<std::string>& notes);

}  // namespace octet
