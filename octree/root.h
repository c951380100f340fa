// SPDX-License-Identifier: BSD-3-Clause
// The root cube: where the lattice lies in space.
#pragma once

#include <array>

#include "base/vec.h"
#include "octree/octant.h"

namespace octet {

/// The cube [origin, origin + size]^3 and the lattice over it.
struct Root {
  Vec3 origin = Vec3::Zero();
  double size = 0.0;

  /// Edge length of an octant of that level, model units.
  [[nodiscard]] double length(int level) const { return size / static_cast<double>(1u << level); }
  [[nodiscard]] Vec3 position(const Lattice& p) const {
    const double cell = length(kLatticeLevels);
    return {origin.x() + cell * p[0], origin.y() + cell * p[1], origin.z() + cell * p[2]};
  }
  [[nodiscard]] Box3 box(const Octant& o) const {
    const std::uint32_t e = o.extent();
    return {position(o.corner), position({o.corner[0] + e, o.corner[1] + e, o.corner[2] + e})};
  }
  /// The lattice cell that holds p (lower faces included); points outside the root are clamped into it.
  [[nodiscard]] Lattice cell_of(const Vec3& p) const;
};

struct PlacedRoot {
  Root root;
  int level = 0;  ///< of an octant of the size asked for
};

/// sqrt 10 - 3, sqrt 7 - 2, 2 - sqrt 3: of the small square roots these stay 0.07 octants away from every
/// octant plane for nine levels below the size, so that a plane of the box meets no octant plane there. Of
/// their orders and reflections the one with which sizes and rates in the tests were nearest to what is
/// asked.
inline constexpr std::array<double, 3> kRootShift{0.16227766016837933, 0.6457513110645906,
                                                  0.2679491924311227};

/// A root around `box` in which `size` is a level, with at least 2.5 sizes of outside on every side, shifted
/// so that the lower planes of the box lie `shift` sizes above planes of octants of that size; each in [0,
/// 1).
///
/// Ensures that every lattice point, and every octant's centre, is exact in doubles: eight corners of an
/// octant lie exactly on one sphere, so that ties are broken by rank and not by rounding. For that the size
/// is rounded down, by less than 1e-8 of itself for parts no farther from the origin than 16 root edges.
/// LimitError when the size needs more than kDeepestLevel levels; InputError when it is not a positive
/// number.
[[nodiscard]] PlacedRoot place_root(const Box3& box, double size,
                                    const std::array<double, 3>& shift = kRootShift);

}  // namespace octet
