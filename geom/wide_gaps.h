// SPDX-License-Identifier: BSD-3-Clause
// Edges and vertices whose measured gaps are a danger to a mesh.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

struct WideGap {
  ModelRef entity;
  double gap = 0.0;    ///< how far an edge runs beside its faces, or a vertex lies off the ends of its edges
  double local = 0.0;  ///< the size there: that asked for, or the edge's own length where that is less
  Vec3 place = Vec3::Zero();
};

/// A gap is wide above this share of the local size.
inline constexpr double kWideGapShare = 0.05;

/// Gaps, as measured at load (ModelEdge::tolerance, ModelVertex::tolerance), that are wide for a mesh of
/// `size`. The widest share first, ties by dimension and tag.
[[nodiscard]] std::vector<WideGap> wide_gaps(const Model& model, double size);

}  // namespace octet
