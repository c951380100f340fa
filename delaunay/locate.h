// SPDX-License-Identifier: BSD-3-Clause
// The walk to the tetrahedron that holds a point.
#pragma once

#include "delaunay/complex.h"

namespace octet {

/// A finite tetrahedron that holds the point in its closure, or a ghost beyond whose facet it strictly lies.
/// Walks from `start`, which is alive, across faces that separate it from the point; in a Delaunay
/// triangulation such a walk ends, whichever such face it takes [Edelsbrunner 1990]. Invalid when it would
/// leave the block.
[[nodiscard]] TetId walk_to(const Complex& complex, const Block& block, const Vec3& point, TetId start);

}  // namespace octet
