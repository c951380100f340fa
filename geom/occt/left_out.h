// SPDX-License-Identifier: BSD-3-Clause
// What of the shape as read is in no solid.
#pragma once

#include "geom/occt/numbering.h"
#include "geom/provenance.h"

namespace octet {

/// Solids as read that are not in the model, then faces of no such solid, then edges of no such face, then
/// vertices of no such edge, each with its measure and a place on it. Names are left to the caller.
[[nodiscard]] std::vector<LeftOut> left_out(const ShapeMaps& as_read, const Numbering& numbering);

}  // namespace octet
