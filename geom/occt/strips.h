// SPDX-License-Identifier: BSD-3-Clause
// Faces that are no more than an edge or a vertex.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Merges the two sides of every face that is no wider than twice the tolerance of the vaguer of them, than
/// twice as far as that runs beside the face, or than `least` (mm): such a side may run anywhere in the face,
/// and where it crosses the other no surface is between them. The surface of such a face may be anywhere. None is merged where OCCT, which does it, would merge faces that are as narrow but exact.
[[nodiscard]] Repair merge_strips(const TopoDS_Shape& solid, double least);

/// Makes a vertex of every face whose edges are all within `width` (mm) of one place. As above.
[[nodiscard]] Repair shrink_spots(const TopoDS_Shape& solid, double width);

}  // namespace octet
