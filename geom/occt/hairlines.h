// SPDX-License-Identifier: BSD-3-Clause
// Parts of a face that are no wider than a line.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Closes every spike or slit of a face: two of its sides that run against each other between the same two
/// vertices, and are nowhere farther apart than `width` or their tolerance. The one of the lesser tolerance
/// takes the place of the other on the face beyond, with a curve there, and both leave the loop; sides of two
/// loops leave one loop behind, and a loop that falls in two, at a neck without width, parts the face. Sides
/// a period apart, where the face closes on itself, become a piece of its seam.
[[nodiscard]] Repair close_hairlines(const TopoDS_Shape& solid, double width);

}  // namespace octet
