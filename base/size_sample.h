// SPDX-License-Identifier: BSD-3-Clause
// A wish for a mesh size at a place, and who has it.
#pragma once

#include <cstdint>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// Why a size is wanted.
enum class SizeReason : std::uint8_t {
  kGlobal,     ///< the size asked for, everywhere
  kAttribute,  ///< asked for by the user, there
  kShortEdge,  ///< an edge shorter than the size
  kEdgeGap,    ///< another edge runs close by
  kCurvature,
  kWall,         ///< the part is thin there
  kGap,          ///< another part of the boundary is near, across the outside
  kSmallRegion,  ///< a region that would have smaller elements alone
};

/// Elements around `place` should have edges no longer than `size` (model units).
struct SizeSample {
  Vec3 place = Vec3::Zero();
  double size = 0.0;
  ModelRef on = {};  ///< the entity that asks; not valid for none
  SizeReason why = SizeReason::kAttribute;
  bool at_most = false;  ///< octants no longer than `size`; else the level nearest to it will do
};

}  // namespace octet
