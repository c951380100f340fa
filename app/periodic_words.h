// SPDX-License-Identifier: BSD-3-Clause
// What the user asks to be periodic, in words.
#pragma once

#include <string_view>
#include <vector>

#include "app/mesh_part.h"
#include "geom/periodicity.h"

namespace octet {

/// From `x`, `y` or `z` (the faces in the least plane across this axis, and those in the greatest), or
/// `PLACES=PLACES`, the faces and their images, places as of parse_group(). `unit`: as there. InputError with
/// the reason when the text means nothing.
[[nodiscard]] PeriodicWish parse_periodic(std::string_view text, double unit = 1.0);

/// The faces that the wishes name. InputError where a place is nowhere in the model, or is no face's.
[[nodiscard]] std::vector<PeriodicFaces> periodic_faces(const Model& model,
                                                        const std::vector<PeriodicWish>& wishes);

}  // namespace octet
