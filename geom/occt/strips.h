// SPDX-License-Identifier: BSD-3-Clause
// Faces that the file itself knows no better than an edge.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct StripsMerged {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> faces;  ///< that are gone; none: `solid` is the one given
};

/// Merges the two sides of every face that is no wider than twice the tolerance of the vaguer of them, or
/// than `least` (mm): such a side may run anywhere in the face, and where it crosses the other no surface
/// is between them. None is merged where OCCT, which does it, would merge faces that are as narrow but exact.
/// Whether the result is closed is for the caller to test.
[[nodiscard]] StripsMerged merge_strips(const TopoDS_Shape& solid, double least);

/// Makes a vertex of every face whose edges are all within `width` (mm) of one place. As above.
[[nodiscard]] StripsMerged shrink_spots(const TopoDS_Shape& solid, double width);

}  // namespace octet
