// SPDX-License-Identifier: BSD-3-Clause
// Edges that run beside the faces that they bound.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct EdgeRedrawn {
  TopoDS_Edge edge;
  double gap = 0.0;  ///< mm, from its faces, before
};

/// Draws edges of two faces anew, in place, where these meet, if they run beside one of them by more than
/// kStrayShare of their solid's diagonal: general fuses leave such under a tolerance, where an edge given
/// had one as wide, and so do files of other systems. What ends there moves to where all faces meet that it
/// is on; other edges there are lengthened or shortened along their curves. Between faces of one
/// surface, or that touch nearly tangent, an edge goes to the nearest place on both. It stays where its faces
/// do not meet nearby, where one is a strip, no wider than a few gaps, and where what is at one of its ends
/// cannot follow.
[[nodiscard]] std::vector<EdgeRedrawn> redraw_stray_edges(const std::vector<TopoDS_Shape>& solids);

/// Less of the diagonal is for sizes and tolerances to deal with.
inline constexpr double kStrayShare = 5e-4;

}  // namespace octet
