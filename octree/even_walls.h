// SPDX-License-Identifier: BSD-3-Clause
// Octants of one size on both sides of thin walls and gaps.
#pragma once

#include "octree/octree.h"

namespace octet {

/// A wall no thicker than this many spacings of points (Octree::spacing_at()) is thin: no octree vertices lie
/// in it, and its two sheets see each other's points.
inline constexpr double kThinWall = 1.3;

/// Splits octants on the boundary until none has a smaller octant across a thin wall or gap. A ball that
/// touches the coarser sheet only would be wider than the wall and hold points of the finer one, so that its
/// points had no facets [docs/ARCHITECTURE.md, "Points"]. Across is where the normal at the place nearest to
/// the octant's centre meets a sheet that faces it, not within a fiftieth of that reach: one octant holds
/// both sheets there. Ends, for no octant gets smaller than one that there is.
[[nodiscard]] Octree with_even_walls(const Model& model, Octree tree);

}  // namespace octet
