// SPDX-License-Identifier: BSD-3-Clause
// The entities of a part for people. Lengths are millimetre.
#pragma once

#include <string>

#include "app/at_place.h"
#include "app/entity_shapes.h"

namespace octet {

/// One line per entity in columns, a heading above those of each dimension: type, measure, place and shape,
/// what it bounds, tolerance, name and marks, numbers as read where they differ, ids of the file.
[[nodiscard]] std::string entity_table(const Model& model, const EntityShapes& shapes);
/// What is at a place: a line that says it, and one for each of the nearest entities.
[[nodiscard]] std::string place_lines(const Model& model, const EntityShapes& shapes, const AtPlace& at);

}  // namespace octet
