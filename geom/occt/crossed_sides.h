// SPDX-License-Identifier: BSD-3-Clause
// Sides of a loop that begin on the wrong side of each other.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Splits neighbouring sides of a face's loop where they cross again, after running side by side nearer than
/// their tolerances from the vertex that they share. Where a fillet runs out on a plane the curve that the
/// CAD system fitted often begins beyond the plane's edge: between that vertex and the crossing the face is
/// inside out, and no mesh has such a one. The pieces share a vertex, and close_hairlines() makes one of the
/// two that lead to the old one.
[[nodiscard]] Repair split_crossed_sides(const TopoDS_Shape& solid);

}  // namespace octet
