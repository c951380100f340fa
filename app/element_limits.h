// SPDX-License-Identifier: BSD-3-Clause
// What more elements than there may be are told by, and told as.
#pragma once

#include <optional>

#include "app/mesh_part.h"
#include "octree/octree.h"

namespace octet {

/// Octants inside and on the boundary beyond which a mesh has more elements than that, whatever the part.
[[nodiscard]] std::size_t most_octants_within(std::size_t max_elements);

/// LimitError where the part's volume at the size h already takes more elements than the control allows.
void check_volume(const Model& model, const SizeControl& control, double h);

/// LimitError for octants, inside and on the boundary, that make far more elements than the plan allows.
void check_octants(const SizePlan& plan, std::size_t within);

/// Lines of LimitErrors: the wish that asks for most of them is named, else the place where a field wants the
/// smallest size, else the size. `elements`: how many there would be, 0 where that is not known.
[[nodiscard]] std::string too_many_elements(const SizePlan& plan, const std::optional<Box3>& finest,
                                            double elements = 0.0);
[[nodiscard]] std::string too_fine(const Model& model, const TooFine& fine);

}  // namespace octet
