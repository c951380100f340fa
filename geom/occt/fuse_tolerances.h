// SPDX-License-Identifier: BSD-3-Clause
// The tolerances that a general fuse of solids is tried with.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace octet {

/// More solids take too long to be fused once more where it can be done without.
inline constexpr std::size_t kMostAgain = 8;

/// Ascending (mm), the first is none. What those above the noise of files (geom/tiny_features), and above
/// `noise`, give must leave nothing to be wished for.
[[nodiscard]] std::vector<double> fuse_tolerances(const std::vector<TopoDS_Shape>& solids, double noise);

}  // namespace octet
