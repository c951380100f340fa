// SPDX-License-Identifier: BSD-3-Clause
// Faces that run through a pole of their surface, in parts that end there.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// A pole inside a face is a point at which two parts of the face meet: a bent pin's torus, whose bend is
/// tighter than the pin is thick, goes through its own axis and has the part beyond turned inside out.
/// Such faces are parted along the line of v that is the pole, and edges that cross it are cut there; the
/// parts share the pole's vertex. `entities` are the faces. Loops that cannot be told apart are left.
[[nodiscard]] Repair split_pinched_faces(const TopoDS_Shape& solid);

}  // namespace octet
