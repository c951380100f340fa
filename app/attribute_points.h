// SPDX-License-Identifier: BSD-3-Clause
// The loop between classification and triangulation: attribute points until no topological hole is left.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "base/observer.h"
#include "classify/band.h"
#include "classify/gaps.h"
#include "delaunay/triangulation.h"
#include "geom/edge_match.h"

namespace octet {

/// On the same face.
struct OtherPlace {
  Vec3 point = Vec3::Zero();
  double clear = 0.0;  ///< how far from others of the face
};

/// Of a point on an edge or face, on another one that is periodic with it.
struct ImagePoint {
  ModelRef on;
  Vec3 point = Vec3::Zero();
  double t = 0.0;  ///< on an edge
};

struct AttributeLimits {
  std::size_t rounds = 60;
  std::size_t points = 0;                                      ///< at most so many attribute points
  std::size_t gaps = std::numeric_limits<std::size_t>::max();  ///< more than so many end it at once
  double floor = 0.0;  ///< no point goes in closer than this to another (model units)
  /// Number of the cell (an octant) that holds a place, each with at most `per_cell` points for its gaps;
  /// none: one cell.
  std::function<std::size_t(const Vec3&)> cell_at;
  std::size_t per_cell = std::numeric_limits<std::size_t>::max();
  /// kAll: where a piece of an edge cannot be had, so that what is elsewhere is closed all the same.
  GapScope scope = GapScope::kPiecesFirst;
  /// Where a point of a face goes rather than to its own place, if no point of the face is there yet; none:
  /// it stays.
  std::function<std::optional<OtherPlace>(int face, const Vec3&)> elsewhere;
  /// What goes in with a point, wherever that is; none: nothing.
  std::function<std::vector<ImagePoint>(ModelRef on, const Vec3&)> images;
};

struct AttributeResult {
  std::vector<Gap> gaps;  ///< what is left
  std::size_t rounds = 0;
  std::size_t points = 0;            ///< inserted
  std::size_t rejected = 0;          ///< wanted, but closer than the floor to another point
  std::vector<std::size_t> crowded;  ///< where gaps are left: the cells whose gaps took many points, sorted
};

/// Inserts attribute points into the triangulation, in matched pairs, until find_gaps() is empty or a limit
/// is met. `on` grows with the points. [Schroeder & Shephard 1990, "Classification and compatibility"]
[[nodiscard]] AttributeResult close_gaps(Triangulation& triangulation, Band& band, EdgeChains& chains,
                                         std::vector<ModelRef>& on, const EdgeIndex& edges,
                                         const AttributeLimits& limits, Observer& observer);

}  // namespace octet
