// SPDX-License-Identifier: BSD-3-Clause
// Faces that solids have alike become one before the solids are fused.
#pragma once

#include "geom/occt/solids.h"

namespace octet {

/// Faces of different solids with the same place and the same edges, but for what their tolerances and
/// kRoundingShare of the smaller solid's diagonal allow, become that of the first solid, which the others
/// then share. A solid whose faces are all another's is that one, and leaves the set. Such faces need no
/// intersection, which for free-form ones is slow, and which OCCT gets wrong for cylinders seam on seam.
/// Solids that are not closed stay as they are. Tells in a note how many.
void join_common_faces(SolidSet& set);

}  // namespace octet
