// SPDX-License-Identifier: BSD-3-Clause
// Trims of simple shape: the whole surface, a band of v, a disc, a convex polygon.
#pragma once

#include <memory>
#include <vector>

#include "geom/surface.h"

namespace octet {

/// Everything is in.
[[nodiscard]] std::shared_ptr<const Trim> make_whole_trim();
/// v0 <= v <= v1, any u; on within `tolerance` of either bound.
[[nodiscard]] std::shared_ptr<const Trim> make_band_trim(double v0, double v1, double tolerance);
[[nodiscard]] std::shared_ptr<const Trim> make_disc_trim(const Vec2& centre, double radius, double tolerance);
/// Corners of a convex polygon, counter-clockwise.
[[nodiscard]] std::shared_ptr<const Trim> make_polygon_trim(std::vector<Vec2> corners, double tolerance);

}  // namespace octet
