// SPDX-License-Identifier: BSD-3-Clause
// Vertices that lie on an edge of their face.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct TouchedEdgesSplit {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> edges;  ///< that were split; none: `solid` is the one given
};

/// Splits every edge that a vertex of one of its faces lies on: nearer than the tolerances of the two or than
/// `width` (mm; seams by the tolerances alone), though the edge neither ends there nor near. The pieces share
/// the vertex. To the file the face is pinched to a point there, which no mesh shows whose edges pass each
/// other. Whether the result is closed is for the caller to test.
[[nodiscard]] TouchedEdgesSplit split_touched_edges(const TopoDS_Shape& solid, double width);

}  // namespace octet
