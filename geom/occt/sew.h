// SPDX-License-Identifier: BSD-3-Clause
// Loose faces sewn to closed shells.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace octet {

struct Sewn {
  TopoDS_Shape shape;                 ///< all faces, sewn
  std::vector<TopoDS_Shape> solids;   ///< of the closed shells, turned outwards
  Handle(BRepTools_History) history;  ///< of faces, edges and vertices
  double tolerance = 0.0;             ///< that was used
  std::size_t free_edges = 0;         ///< left
};

/// Sews `faces` with `tolerance`; with 0, by growing tolerances until no free edge is left, the largest a
/// ten-thousandth of their diagonal: above that sewing joins what is meant to be apart. Of all tolerances the
/// result is that with closed shells, and then with the fewest free edges. No solids: nothing closed.
[[nodiscard]] Sewn sew_faces(const std::vector<TopoDS_Shape>& faces, double tolerance);

/// Closed shells of `shape` outside its solids, as solids turned outwards.
[[nodiscard]] std::vector<TopoDS_Shape> solids_from_shells(const TopoDS_Shape& shape);

}  // namespace octet
