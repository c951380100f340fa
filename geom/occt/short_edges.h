// SPDX-License-Identifier: BSD-3-Clause
// Edges too short to be meant.
#pragma once

#include "geom/occt/repair.h"

namespace octet {

/// Drops every edge no longer than `length` (mm); its two vertices become one. Nothing is done where a face
/// would go with it.
[[nodiscard]] Repair drop_short_edges(const TopoDS_Shape& solid, double length);

}  // namespace octet
