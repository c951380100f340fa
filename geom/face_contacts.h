// SPDX-License-Identifier: BSD-3-Clause
// Faces of solids that are kept apart and lie on each other.
#pragma once

#include <array>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Two faces of different regions, one's outside against the other's.
struct FaceContact {
  std::array<int, 2> face{};    ///< ascending tags
  std::array<int, 2> region{};  ///< behind each
  double area = 0.0;  ///< that they share: the smaller face's where it lies on the other as a whole, else as
                      ///< facets tell
  Vec3 place = Vec3::Zero();  ///< on the first, within what they share
};

/// Places are one within both faces' tolerances and this share of the model's diagonal.
inline constexpr double kContactShare = 1e-6;

/// The pairs that share an area, ascending; those that touch along lines or in points are none, nor are
/// solids that reach into each other. Facets tell where to look, the exact faces whether they touch there.
/// Cost: O(n log n) in the facets of each two faces whose boxes meet, exact queries of those that touch.
[[nodiscard]] std::vector<FaceContact> face_contacts(const Model& model);

}  // namespace octet
