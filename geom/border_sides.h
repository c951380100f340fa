// SPDX-License-Identifier: BSD-3-Clause
// Which sides of which facets lie on which model edge, and which facet nodes are model vertices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/curve_samples.h"
#include "geom/model.h"

namespace octet {

/// A facet side that stands for a piece of a real model edge.
struct BorderSide {
  int edge = 0;
  double t = 0.0;  ///< parameter of the edge near the side's middle: a hint for projection
  std::uint32_t a = 0, b = 0;
  double reach = 0.0;  ///< how far the curve and its tolerance, or the vertices' points, may be off the chord
};

/// Immutable; -1 and 0 mean none. Seams and degenerate edges have no border sides.
struct BorderSides {
  std::vector<BorderSide> sides;
  std::vector<std::array<std::int32_t, 3>> of_triangle;  ///< side opposite each corner, index into `sides`
  std::vector<std::int32_t> node_vertex;                 ///< per node: model vertex tag
};

/// `tolerance` is the model's.
[[nodiscard]] BorderSides find_border_sides(const ModelParts& parts, const std::vector<CurveSamples>& samples,
                                            double tolerance);

/// Per triangle: how far the exact face may lie from it, boundary chords and tolerances included.
[[nodiscard]] std::vector<double> facet_growth(const ModelParts& parts, const BorderSides& border,
                                               double tolerance);

}  // namespace octet
