// SPDX-License-Identifier: BSD-3-Clause
// Faces that were given the rest of their sphere.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Of two faces on one sphere that lie on the same side of an edge that they share, the larger one gets the
/// other side of its loop. A loop through both poles bounds two parts of its sphere; which one is meant tells
/// the file by the way round, but between the poles OCCT's reader may take curves to be a turn off, and turns
/// the loop so that it fits. Faces must agree along their edges. `entities`: the faces.
[[nodiscard]] Repair choose_sphere_sides(const TopoDS_Shape& solid);

}  // namespace octet
