// SPDX-License-Identifier: BSD-3-Clause
// Faces between two loops that are no more than one loop.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Takes away every face between two closed loops of edges that run beside each other, edge by edge, nowhere
/// farther apart than `width` (mm), as the ledge where a bore meets a slightly wider one: the edges of one
/// loop take the place of the other's on the faces beyond. Edges may lack curves on these: the caller adds
/// them. Faces that share an edge or a vertex with one that goes stay.
[[nodiscard]] Repair merge_rings(const TopoDS_Shape& solid, double width);

}  // namespace octet
