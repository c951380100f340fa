// SPDX-License-Identifier: BSD-3-Clause
// Parts of a face that are no wider than a line.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct HairlinesClosed {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> edges;  ///< that are gone; none: `solid` is the one given
};

/// Closes every spike or slit of a face's loop: two sides in a row, between the same two vertices, that are
/// nowhere farther apart than `width`. One takes the place of the other on the face beyond, and both leave
/// the loop. Whether the result is closed is for the caller to test.
[[nodiscard]] HairlinesClosed close_hairlines(const TopoDS_Shape& solid, double width);

}  // namespace octet
