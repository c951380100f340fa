// SPDX-License-Identifier: BSD-3-Clause
// `octet info` for people. Lengths are millimetre.
#pragma once

#include <string>

#include "app/part_info.h"

namespace octet {

/// The part in a page: size, counts, tree of parts, smallest things, names, faults, notes.
[[nodiscard]] std::string part_text(const Model& model, const PartInfo& info);
/// One line per entity: type, measure, tolerance, what it bounds, marks, numbers as read where they differ.
[[nodiscard]] std::string entity_table(const Model& model);

}  // namespace octet
