// SPDX-License-Identifier: BSD-3-Clause
// Edges without length where their face is no point.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Edges are taken away that are said to be degenerate, but whose curve on the face runs along a line of it
/// that has length. OCCT's reader of STEP files adds them where it turns a curve on a surface of revolution
/// the wrong way around; the loop then spans two turns, and the face is twice its area. `entities` are the
/// faces.
[[nodiscard]] Repair drop_false_poles(const TopoDS_Shape& solid);

}  // namespace octet
