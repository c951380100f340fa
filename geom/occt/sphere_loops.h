// SPDX-License-Identifier: BSD-3-Clause
// Loops on a sphere: what they bound, and an axis clear of them.
#pragma once

#include <TopoDS_Edge.hxx>

#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace octet {

/// An edge, turned as its loop runs, and directions from the sphere's centre along it, both ends included.
struct SphereSide {
  TopoDS_Edge edge;
  std::vector<Vec3> at;  ///< of length 1
};

/// Sides in order. What it bounds lies to its left, seen from outside.
using SphereLoop = std::vector<SphereSide>;

/// Of the part of the unit sphere to the left of a loop: steradian, 0 to 4 pi.
[[nodiscard]] double left_area(const SphereLoop& loop);

/// Of the part to the left of all loops, which are apart; not between 0 and 4 pi where no part is.
[[nodiscard]] double area_between(const std::vector<SphereLoop>& loops);

/// A frame of (u,v) in which loops are closed curves but for one at most, which then goes once around
/// (`ring`, with u falling, and the pole below it belongs to what the loops bound). Else both poles belong to
/// that.
struct SphereFrame {
  Vec3 up, across;  ///< v = 90 degrees; u = v = 0
  int ring = -1;
  /// The side of the ring from whose start a meridian runs to the pole below and meets no loop; without a
  /// ring, the meridian u = 0 meets none.
  std::size_t start = 0;
  double clearance = 0.0;  ///< from the poles to the loops, radian
};

/// The frame with the poles farthest from the loops; none where all have one within half a degree of them.
[[nodiscard]] std::optional<SphereFrame> clear_frame(const std::vector<SphereLoop>& loops);

}  // namespace octet
