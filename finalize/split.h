// SPDX-License-Identifier: BSD-3-Clause
// Edge split: a new vertex on an edge, at once moved to the place that is best for all around it.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Splits edge ab of tetrahedron t if the worst shape around it gets better than `floor`. The new vertex lies
/// on the model entity that the edge lies on, and is moved until that shape is `goal`, or the best.
bool split_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor, double goal);

/// An upper bound of the worst shape that a split of the ring's edge can leave, wherever the new vertex goes:
/// it parts the dihedral angle of each tetrahedron at the edge that is opposite the one split, and one part
/// has no more than half of it.
[[nodiscard]] double most_of_split(const WorkMesh& mesh, const EdgeRing& ring);

}  // namespace octet
