// SPDX-License-Identifier: BSD-3-Clause
// `octet info` for programs: JSON text. Lengths are millimetre.
#pragma once

#include <string>

#include "app/at_place.h"
#include "app/entity_shapes.h"
#include "app/part_info.h"

namespace octet {

[[nodiscard]] std::string part_info_json(const std::string& part, const Model& model, const PartInfo& info,
                                         const EntityShapes& shapes, const std::vector<AtPlace>& places);

}  // namespace octet
