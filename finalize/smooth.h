// SPDX-License-Identifier: BSD-3-Clause
// Node repositioning: the constrained Laplacian, and the line search for the worst element.
#pragma once

#include "finalize/local_star.h"

namespace octet {

/// Improves the smallest shape of the star, which is `worst` at `stand`, towards `goal` by moving the vertex
/// along directions that raise all of the nearly worst dihedral angles, with a golden section search on each
/// line [Handbook 15.6.1]. Returns the shape reached (>= worst), `stand` where.
double raise_worst(Workshop& shop, const LocalStar& star, Stand& stand, double worst, double goal);

/// Moves the vertex so that the worst of its tetrahedra gets better than before by kGain; aims at `goal`.
/// False when it stays.
bool smooth_vertex(Workshop& shop, VertexId v, double goal);

/// The constrained Laplacian alone: the average of the neighbours on the vertex's own entity, or the first of
/// the points on the way there that betters the worst tetrahedron [Handbook 15.6.1].
bool laplacian_step(Workshop& shop, VertexId v);

}  // namespace octet
