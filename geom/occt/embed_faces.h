// SPDX-License-Identifier: BSD-3-Clause
// Loose faces become faces embedded in the solids that they lie in.
#pragma once

#include "geom/occt/solids.h"

namespace octet {

/// What of the faces of the shape as read that bound no solid lies within a solid becomes part of that, with
/// the same region on both sides; where it ends on a face, that face gets the edge. Faces that reach across a
/// solid part it. Faces embedded in a solid already stay as they are. To be called once solids share what
/// they touch in. Appends notes of what was embedded and parted, and, where OCCT cannot do it or the solids
/// would not be what they were, why nothing was.
void embed_faces(const ShapeMaps& as_read, SolidSet& set);

}  // namespace octet
