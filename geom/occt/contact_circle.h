// SPDX-License-Identifier: BSD-3-Clause
// The circle along which two surfaces of revolution touch.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

namespace octet {

/// Surfaces touch that come as near as this share of the diagonal. Where they were meant to touch they do to
/// 1e-16 in most files; a step of 5e-8 of a tank's diagonal, taken for a contact, left 22 000 flat elements.
inline constexpr double kContactShare = 1e-8;

/// The circles along which the surfaces of two faces touch without crossing, no farther than `tolerance` from
/// each other there: of a torus or a sphere with a plane, cylinder, cone, sphere or torus of the same axis,
/// and of a sphere in a tube of its own radius. OCCT intersects such surfaces in points by rounding, or not
/// at all. Whole circles, also where the faces end before; none along an edge of either face, for there they
/// meet in that.
[[nodiscard]] std::vector<TopoDS_Edge> contact_circles(const TopoDS_Face& a, const TopoDS_Face& b,
                                                       double tolerance);

}  // namespace octet
