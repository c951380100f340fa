// SPDX-License-Identifier: BSD-3-Clause
// A mesh of first order as one of second order: a node in the middle of every edge.
#pragma once

#include "mesh/mesh.h"

namespace octet {

/// The nodes of all edges, in the middle of the straight edge. Requires the invariants of mesh/mesh.h.
/// O(tetrahedra), in parallel. LimitError when there are more nodes than indices.
[[nodiscard]] MidNodes straight_mid_nodes(const Mesh& mesh);

}  // namespace octet
