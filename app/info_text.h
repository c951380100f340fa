// SPDX-License-Identifier: BSD-3-Clause
// `octet info` for people. Lengths are millimetre.
#pragma once

#include <string>

#include "app/part_info.h"

namespace octet {

/// The part in a page: size, counts, tree of parts, smallest things, names, faults, notes.
[[nodiscard]] std::string part_text(const Model& model, const PartInfo& info);

}  // namespace octet
