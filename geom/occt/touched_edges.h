// SPDX-License-Identifier: BSD-3-Clause
// Vertices that lie on an edge of their face.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Splits every edge that a vertex of one of its faces lies on: nearer than the tolerances of the two or than
/// `width` (mm; seams by the tolerances alone), though the edge neither ends there nor near. The pieces share
/// the vertex. To the file the face is pinched to a point there, which no mesh shows whose edges pass each
/// other.
[[nodiscard]] Repair split_touched_edges(const TopoDS_Shape& solid, double width);

}  // namespace octet
