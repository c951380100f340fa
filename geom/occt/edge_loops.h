// SPDX-License-Identifier: BSD-3-Clause
// Edges that run around in loops.
#pragma once

#include <TopoDS_Edge.hxx>
#include <vector>

namespace octet {

/// Edges of a loop in a row, each oriented as the loop runs.
using EdgeLoop = std::vector<TopoDS_Edge>;

/// The loops that the edges form by their vertices. A loop may meet others in one vertex; edges whose way is
/// open, or is not the only one, are in none. In the order of the edges.
[[nodiscard]] std::vector<EdgeLoop> edge_loops(const std::vector<TopoDS_Edge>& edges);

}  // namespace octet
