// SPDX-License-Identifier: BSD-3-Clause
// Faces whose loop crosses itself, in parts of one side each.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Where two sides of a loop cross the loop turns over: what it goes around beyond is inside out (the sides
/// of a chamfer that narrows to nothing and goes on). The two are cut there at a common vertex, and the face
/// becomes one for each lobe, turned as its loop runs. `entities` are the faces. Faces of several loops of
/// which it is not clear which lobe has the others are left.
[[nodiscard]] Repair split_crossed_loops(const TopoDS_Shape& solid);

}  // namespace octet
