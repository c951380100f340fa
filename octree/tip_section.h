// SPDX-License-Identifier: BSD-3-Clause
// How wide a tip is, and which way it points, by the ways that lead from its end along its faces.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geom/model.h"

namespace octet {

/// What narrows to nothing about a pole, by ways that lead from the pole along it.
struct TipSides {
  double length = 0.0;      ///< from the pole to the farthest point
  std::vector<Vec3> sides;  ///< unit

  /// Those of a face, by the exact face beside its facets at the pole.
  void add(const Model& model, std::size_t facet, const Vec3& pole);
  void add(const TipSides& other);
  [[nodiscard]] Vec3 mean() const;
  /// Whether both point the same way, but for what either is wide.
  [[nodiscard]] bool point_as(const TipSides& other) const;
};

/// A tip as seen along its axis, at the distance 1 from its end: about an ellipse.
struct TipSection {
  Vec3 along = Vec3::Zero(), across = Vec3::Zero();  ///< the axis, and the way in which it is wide; unit
  double taper = 0.0, lesser_taper = 0.0;            ///< half the ellipse's axes
  bool winds = false;                                ///< half around the axis, or farther
};

/// None where the tip is blunt: half as thick, in the direction in which it is narrow, as a quarter of the
/// distance from its end, or half as wide as all of that. Beyond, a ring of points has room at three spacings
/// from the end.
[[nodiscard]] std::optional<TipSection> section_of(const TipSides& sides);

}  // namespace octet
