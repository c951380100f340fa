// SPDX-License-Identifier: BSD-3-Clause
// Edges and faces that are no larger than the CAD knows where they are.
#pragma once

#include <cstddef>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Of the diagonal: what is no longer or wider is what a modeller's or a translator's rounding left. Nothing
/// of a part's volume is in it, and a mesh has flat elements all along it.
inline constexpr double kRoundingShare = 1e-6;

struct TinyFeature {
  ModelRef entity;
  double size = 0.0;  ///< an edge's length, a face's width
  double gap = 0.0;   ///< what it is compared with
  Vec3 place = Vec3::Zero();
};

/// Real edges no longer, and faces no wider, than twice the gaps measured around them (of an edge and its
/// vertices, of a face's edges and theirs), or than kRoundingShare of the diagonal: remains of a modeller's
/// or translator's tolerance. The width of a face is twice its area over its perimeter, that of a strip
/// between two long sides. Ascending by dimension and tag.
[[nodiscard]] std::vector<TinyFeature> tiny_features(const Model& model);

/// Real edges no longer, and faces no wider, than `length`.
[[nodiscard]] std::size_t features_within(const Model& model, double length);

/// As tiny_features() for one face.
[[nodiscard]] bool is_sliver(const Model& model, int face);

}  // namespace octet
