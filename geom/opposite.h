// SPDX-License-Identifier: BSD-3-Clause
// The partner of a boundary point across a thin wall, a thin gap or a knife edge.
#pragma once

#include <cstdint>
#include <optional>

#include "geom/model.h"

namespace octet {

/// The point b such that a ball touches the model's boundary at a (with its centre on the given side of the
/// face, along the normal) and at b and holds no boundary point: b is a's mirror image in the local medial
/// axis. For two planes that meet in an edge, b has a's distance from that edge; for parallel sheets b is
/// straight across. Found by shrinking the ball (Ma, Bae, Choi 2012). `side` = +1: along `normal`, -1:
/// against it. None when |b - a| > max_distance, or when b is a's own neighbourhood (a smooth, well curved
/// sheet: the ball's radius is the curvature radius and b -> a). The foot's distance is |b - a|.
[[nodiscard]] std::optional<Foot> opposite_point(const Model& model, const Vec3& a, int face_of_a,
                                                 const Vec3& normal, int side, double max_distance);

/// Cosine of the angle between the sheets at a, of this normal, and at its opposite point b. The normals' own
/// sides do not matter: a face between two regions has its normal on either.
[[nodiscard]] double cosine_between(const Vec3& a, const Vec3& normal, const Foot& b);

/// Whether the sheets at a and at its opposite point b enclose less than 45 degrees.
[[nodiscard]] bool face_each_other(const Vec3& a, const Vec3& normal, const Foot& b);

/// Whether a facet stands across `axis`, the cosine of their angle no less than `least`, and has the region
/// `between` on the side that looks back along it.
[[nodiscard]] bool looks_back(const Model& model, std::uint32_t facet, const Vec3& axis, int between,
                              double least);

/// The opposite point where it lies within a face and that face faces a's sheet, none elsewhere. Most places
/// have none, which the facets ahead tell: a twentieth of the cost.
[[nodiscard]] std::optional<Foot> facing_point(const Model& model, const Vec3& a, int face_of_a,
                                               const Vec3& normal, int side, double max_distance);

}  // namespace octet
