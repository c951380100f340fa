// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of tetrahedra.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// Smallest and largest of the six dihedral angles, radians; negative volumes give (0, pi).
struct DihedralRange {
  double smallest = 0.0, largest = 0.0;
};
[[nodiscard]] DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Squared cotangents, with their signs, of the same two angles. They fall as the angle grows, so angles are
/// compared without roots and arcs. Infinite, as of 0 and pi, unless the volume is positive.
struct DihedralCotangents {
  double smallest = std::numeric_limits<double>::infinity(),
         largest = -std::numeric_limits<double>::infinity();
};
[[nodiscard]] DihedralCotangents dihedral_cotangents(const Vec3& a, const Vec3& b, const Vec3& c,
                                                     const Vec3& d);
/// The angle, 0 to pi, and the way back.
[[nodiscard]] double angle_of_cotangent(double squared_cotangent);
[[nodiscard]] double squared_cotangent(double angle);
[[nodiscard]] double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// 12 (3 V)^(2/3) / sum of squared edges, 1 for the regular tetrahedron.
[[nodiscard]] double mean_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// 3 r / R of the inscribed and the circumscribed sphere, 1 for the regular tetrahedron.
[[nodiscard]] double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// sqrt(3/2) of the shortest height over the longest edge, 1 for the regular tetrahedron.
[[nodiscard]] double aspect(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The extreme angles of tetrahedra, radians, right angles where there are none; and how many have one below
/// a target.
struct DihedralExtremes {
  DihedralRange range;
  std::size_t below = 0;
};
[[nodiscard]] DihedralExtremes dihedral_extremes(const Mesh& mesh, double target);

struct QualitySummary {
  std::size_t tets = 0;
  double min_dihedral = 0.0, max_dihedral = 0.0;  ///< radians
  double p1_min_dihedral = 0.0;                   ///< 1st percentile of the elements' smallest dihedrals
  double min_mean_ratio = 0.0, mean_mean_ratio = 0.0;
  std::size_t worst_tet = 0;
  double volume = 0.0;
};
[[nodiscard]] QualitySummary quality_summary(const Mesh& mesh);

}  // namespace octet
