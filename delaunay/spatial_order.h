// SPDX-License-Identifier: BSD-3-Clause
// An order of points in which neighbours in the list are neighbours in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Biased randomized insertion order: rounds of doubling size, drawn by a hash of the point's index, and
/// along a Hilbert curve in each round [Amenta, Choi & Rote 2003]. The same points give the same order
/// everywhere.
[[nodiscard]] std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points);

}  // namespace octet
