// SPDX-License-Identifier: BSD-3-Clause
// Exact geometric signs: a static filter, then exact arithmetic.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace octet {

/// Sign (-1, 0, +1) of det[b-a, c-a, d-a], exact for all finite doubles.
/// +1 when d lies on the side of plane abc from which a, b, c appear counter-clockwise:
/// orient3d((0,0,0),(1,0,0),(0,1,0),(0,0,1)) = +1.
/// A tetrahedron (a,b,c,d) is positive when this is +1.
[[nodiscard]] int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// For a positive tetrahedron abcd: +1 when e lies strictly inside its circumsphere, 0 on it, -1 outside.
[[nodiscard]] int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// Like `insphere`, ties broken by vanishing weights, each of which counts only where those before it leave
/// a tie: one common to all points of a class, larger classes first (base/vertex_order.h); one for each
/// octree vertex, larger ranks first; a quadratic form of the place for all other points; one for each of
/// these, larger ranks first. The form leans the triangulation: of a row of equal boxes of points all are
/// cut along diagonals of one direction, which finalization makes better shapes of than of alternating ones.
/// Never 0 for distinct ranks and orient3d(a,b,c,d) != 0. The regular triangulation it defines is unique.
/// Laws: the sign changes under an odd permutation of a,b,c,d; equals insphere() where that is not 0.
[[nodiscard]] int insphere_ranked(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                                  const std::uint64_t rank[5]);

/// The two steps of insphere_ranked(), for who has a quicker answer between them: insphere() where a filter
/// in doubles is sure of it, else 0; and all of it without the filter.
[[nodiscard]] int insphere_filtered(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                    const Vec3& e);
[[nodiscard]] int insphere_ranked_exactly(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                          const Vec3& e, const std::uint64_t rank[5]);

/// insphere_ranked() for five octree vertices, told by their ranks alone: in 64-bit integers, without the
/// points. 0 when it cannot tell: one of the five is no octree vertex, or they are farther apart than 2^11
/// times their common spacing. Requires distinct ranks and abcd not coplanar.
[[nodiscard]] int insphere_on_lattice(const std::uint64_t rank[5]);

}  // namespace octet
