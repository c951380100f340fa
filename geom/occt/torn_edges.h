// SPDX-License-Identifier: BSD-3-Clause
// Edges that end elsewhere than their vertices are.
#pragma once

#include <TopoDS_Edge.hxx>

namespace octet {

/// Whether an edge ends farther than `near` (mm), and than `share` of the distance between its ends, from its
/// vertex there: the loops that it is in are open.
[[nodiscard]] bool is_torn(const TopoDS_Edge& edge, double near, double share = 0.0);

}  // namespace octet
