// SPDX-License-Identifier: BSD-3-Clause
// Dual segments of facets, and those that meet more of the boundary than the facet stands for.
#pragma once

#include <span>
#include <vector>

#include "classify/band.h"
#include "classify/gaps.h"

namespace octet {

/// The segment between the circumcentres of the two tetrahedra at face `local` of `tet`: it crosses the
/// boundary where the facet stands for it. For a ghost or a flat tetrahedron the end is a point on that side
/// of the facet's centroid, as far as the facet's farthest corner.
struct DualSegment {
  Vec3 inner = Vec3::Zero();  ///< on the side of `tet`
  Vec3 outer = Vec3::Zero();
  bool exact = false;  ///< both ends are circumcentres
};
[[nodiscard]] DualSegment dual_segment(const TetMesh& mesh, TetId tet, int local);

/// Facets that are classified, and yet stand for more than one sheet: their dual segment crosses their face
/// more than once, or another face that shares no edge or vertex with it. Facets between tetrahedra that do
/// not lie where their circumcentres do tell nothing and are passed over. Asked when nothing else is missing:
/// call after find_gaps() found none. [Schroeder & Shephard 1990, "Classification and compatibility"]
[[nodiscard]] std::vector<Gap> find_dual_crossings(Band& band, const TetMesh& mesh,
                                                   std::span<const ModelRef> on);

}  // namespace octet
