// SPDX-License-Identifier: BSD-3-Clause
// Shells that bound nothing.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Takes away every closed shell, of several that a solid has, that is no thicker than the tolerance of its edges
/// or than `thickness` (mm): what lies between its faces, over half of their area. Booleans of CAD systems leave
/// such lenses of two faces, as voids that touch the outside. Cost: the volumes and areas of solids of several
/// shells.
[[nodiscard]] Repair drop_flat_shells(const TopoDS_Shape& solid, double thickness);

}  // namespace octet
