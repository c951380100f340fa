// SPDX-License-Identifier: BSD-3-Clause
// Parts of a face that are no wider than a line.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Closes every spike or slit of a face's loop: two sides in a row, between the same two vertices, that are
/// nowhere farther apart than `width` or their tolerance. The one of the lesser tolerance takes the place of
/// the other on the face beyond, and both leave the loop.
[[nodiscard]] Repair close_hairlines(const TopoDS_Shape& solid, double width);

}  // namespace octet
