// SPDX-License-Identifier: BSD-3-Clause
// Curves in (u,v) for edges on surfaces whose parameters are known in closed form.
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt2d.hxx>

#include <functional>
#include <vector>

#include "base/vec.h"

namespace octet {

/// A surface on which the parameters go once around after a turn: u always, v where it says so.
struct Unrolling {
  Handle(Geom_Surface) surface;
  std::function<gp_Pnt2d(const gp_Pnt&)> at;
  bool v_turns = false;
};

/// Places along an edge as it is turned, both ends included: 49.
[[nodiscard]] std::vector<Vec3> places_along(const TopoDS_Edge& edge);

/// Their parameters, in one list, along edges turned as their loop runs: each place is the nearest to the one
/// before, by whole turns, and the first is near `beside`.
[[nodiscard]] std::vector<gp_Pnt2d> unrolled(const Unrolling& on, const std::vector<TopoDS_Edge>& loop,
                                             gp_Pnt2d beside);

/// The loop as a wire, its edges with curves through these places on the surface (which is to be a new one:
/// edges may have others on old ones). Standard_Failure where a curve cannot be interpolated.
[[nodiscard]] TopoDS_Wire unrolled_wire(const Unrolling& on, const std::vector<TopoDS_Edge>& loop,
                                        const gp_Pnt2d& beside);

}  // namespace octet
