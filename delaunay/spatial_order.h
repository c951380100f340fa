// SPDX-License-Identifier: BSD-3-Clause
// An order of points in which neighbours in the list are neighbours in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Biased randomized insertion order: rounds each eight times as large as the one before, drawn by a hash of
/// the point's index, and along a Hilbert curve in each round [Amenta, Choi & Rote 2003]. The same points
/// give the same order everywhere.
struct SpatialOrder {
  std::vector<std::uint32_t> points;
  std::vector<std::size_t> round_end;  ///< per round: where it ends in `points`
  std::vector<std::uint32_t> curve;    ///< all points along_curve() without a shift
  std::vector<std::uint8_t> round;     ///< per point

  /// The points of the rounds up to this one, along the curve.
  [[nodiscard]] std::vector<std::uint32_t> along_curve_until(std::size_t last_round) const;
};
[[nodiscard]] SpatialOrder spatial_order(std::span<const Vec3> points, std::span<const std::uint64_t> ranks);

/// The given points along a Hilbert curve through the cube that starts `shift` of the extent of all points
/// before them, and is larger by that.
[[nodiscard]] std::vector<std::uint32_t> along_curve(std::span<const Vec3> points,
                                                     std::span<const std::uint32_t> which, double shift);

}  // namespace octet
