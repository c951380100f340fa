// SPDX-License-Identifier: BSD-3-Clause
// The cavity of a new point: what its insertion removes, and what fills it.
#pragma once

#include <vector>

#include "delaunay/complex.h"

namespace octet {

/// Whether the point lies inside the (ranked) circumsphere of the tetrahedron. For a ghost: strictly beyond
/// its hull facet, or in that facet's plane and inside the circle of its corners; there the sphere of the
/// finite tetrahedron behind the facet decides, whose fourth corner has no say in that plane.
[[nodiscard]] bool in_conflict(const Complex& complex, TetId t, const Vec3& point, std::uint64_t rank);

/// Puts all tetrahedra in conflict with the point into the inserter's cavity, from `seed`, which is; breadth
/// first, and lists the faces around them. False when the cavity leaves the inserter's block.
/// [Bowyer 1981; Watson 1981]
[[nodiscard]] bool mark_cavity(Complex& complex, Inserter& inserter, TetId seed, const Vec3& point,
                               std::uint64_t rank);

/// The same tetrahedra in the same order, without marks and faces; for queries.
void find_cavity(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity);

/// How many tetrahedra may replace those of a cavity: hung together by n - 1 faces they have that many more.
[[nodiscard]] inline std::size_t most_replacements(const std::vector<TetId>& cavity) {
  return 2 * cavity.size() + 2;
}

/// Replaces the cavity by the tetrahedra that join the faces around it to v. Requires: the cavity is
/// star-shaped around v (a ranked conflict set always is); slots for most_replacements(). The inserter's
/// `created` gets the new ones, ghosts included.
void replace_cavity(Complex& complex, Inserter& inserter, VertexId v);

}  // namespace octet
