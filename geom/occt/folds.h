// SPDX-License-Identifier: BSD-3-Clause
// Faces folded flat onto a neighbour.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Takes away every face that turns back at an edge and lies on the face beyond it, no farther than its own
/// edges lie from their faces: the two are one sheet to the file, met from both sides. The other sides of the
/// fold become that face's border.
[[nodiscard]] Repair remove_folds(const TopoDS_Shape& solid);

}  // namespace octet
