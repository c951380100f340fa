// SPDX-License-Identifier: BSD-3-Clause
// Node repositioning for the mean: the sum of the distortions of a star is brought to its minimum.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// A vertex's way to a better place.
struct MeanMove {
  Stand stand;
  double step = 0.0;       ///< length as a share of the star's mean edge; 0: stay
  std::uint64_t work = 0;  ///< in evaluations of `shape`
  /// Where triangles of the star lie on curved faces: what the move adds to volumes and areas, and the star's
  /// shapes at the new place.
  std::vector<MeasureChange> changes;
  std::vector<double> shapes;
};

/// One step of Newton's method towards the minimum of the sum of the distortions (finalize/mean_shape.h) of
/// v's star `tets`, on v's model entity. Nothing may get worse than the worst of the star, or than `floor` (a
/// shape) where all are better than that. Changes nothing but `star`, in which the star's shapes at the new
/// place are left; many threads may ask at once, each with a `star` of its own.
[[nodiscard]] MeanMove mean_move(const Workshop& shop, VertexId v, std::span<const TetId> tets, double floor,
                                 LocalStar& star);

}  // namespace octet
