// SPDX-License-Identifier: BSD-3-Clause
// Edge removal: the tetrahedra around an edge are replaced by the best ones without it.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Removes edge ab of tetrahedron t if the worst shape around it gets better than `floor`.
///
/// Inside a region the rim of the edge is triangulated anew, each triangle joined to a and to b (3-2 and 4-4
/// swaps and beyond). On a model face, the same on each side: the two triangles at the edge become the other
/// two of their quadrangle (a surface swap); where one tetrahedron alone stands on them, it is dropped (a
/// flat one, four points of a planar face). Edges on model edges stay. False when nothing was done.
bool remove_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor);

/// The worst shape that remove_edge would reach; 0 when the edge cannot be removed for better than `floor`.
[[nodiscard]] double edge_removal_shape(Workshop& shop, TetId t, VertexId a, VertexId b, double floor);

/// Removes the ring's edge if that raises the sum of merits (finalize/mean_shape.h) and no new tetrahedron is
/// as bad as `floor`.
bool remove_edge_for_mean(Workshop& shop, const EdgeRing& ring, double floor);
/// Whether it would, where the mesh's surface does not forbid it. Changes nothing; many threads may ask at
/// once.
[[nodiscard]] bool edge_removal_raises_mean(const Workshop& shop, const EdgeRing& ring, double floor);

}  // namespace octet
