// SPDX-License-Identifier: BSD-3-Clause
// The section of a part that touches itself.
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace octet::test {

/// A wall from 0 to 1.5, and a finger from the right that ends at `tip`, round or flat; in the plane
/// y = 0, `inner` away from the z axis. At 1.5 its end is on the wall, though they share no edge.
inline TopoDS_Face hook(double inner, double tip, bool round) {
  const auto at = [&](double x, double z) { return gp_Pnt(inner + x, 0.0, z); };
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](const gp_Pnt& a, const gp_Pnt& b) { wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge()); };
  const double start = round ? tip + 0.5 : tip;
  line(at(0, 0), at(6, 0));
  line(at(6, 0), at(6, 4));
  line(at(6, 4), at(start, 4));
  if (round)
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(at(start, 4), at(tip, 3.5), at(start, 3)).Value()));
  else
    line(at(start, 4), at(start, 3));
  line(at(start, 3), at(5, 3));
  line(at(5, 3), at(5, 1));
  line(at(5, 1), at(1.5, 1));
  line(at(1.5, 1), at(1.5, 4.5));
  line(at(1.5, 4.5), at(0, 4.5));
  line(at(0, 4.5), at(0, 0));
  return BRepBuilderAPI_MakeFace(wire.Wire(), true);
}

}  // namespace octet::test
