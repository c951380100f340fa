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

/// All tetrahedra in conflict with the point, from `seed`, which is; breadth first. Marks them in the complex
/// for replace_cavity(). [Bowyer 1981; Watson 1981]
void mark_cavity(Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity);

/// The same tetrahedra in the same order, without marks; for queries.
void find_cavity(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity);

/// Replaces the marked cavity by the tetrahedra that join its boundary to v. Requires: the cavity is
/// star-shaped around v (a ranked conflict set always is). `created` gets the new ones, ghosts included.
void replace_cavity(Complex& complex, VertexId v, const std::vector<TetId>& cavity,
                    std::vector<TetId>& created);

}  // namespace octet
