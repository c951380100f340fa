// SPDX-License-Identifier: BSD-3-Clause
// Loose faces sewn to closed shells.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

#include "geom/occt/caps.h"

namespace octet {

struct SewOptions {
  double tolerance = 0.0;  ///< mm; 0: growing ones
  bool cap = false;        ///< openings that lie in planes are closed by a plane face each
};

struct Sewn {
  TopoDS_Shape shape;                 ///< all faces, sewn, and caps
  std::vector<TopoDS_Shape> solids;   ///< of the closed shells (geom/occt/shell_solids)
  Handle(BRepTools_History) history;  ///< of faces, edges and vertices
  double tolerance = 0.0;             ///< that was used
  std::size_t free_edges = 0;         ///< left
  std::vector<Cap> caps;              ///< in the solids
  std::size_t caps_left = 0;          ///< in the shape, of shells with other openings
};

/// Sews `faces` with the tolerance; with 0, by growing tolerances until no free edge is left, the largest a
/// ten-thousandth of their diagonal: above that sewing joins what is meant to be apart. Of all tolerances the
/// result is that with closed shells, and then with the fewest free edges. Of shells that are open then the
/// openings are capped, where that is asked for; a shell on which other faces hang stays open. No solids:
/// nothing closed.
[[nodiscard]] Sewn sew_faces(const std::vector<TopoDS_Shape>& faces, const SewOptions& options);

}  // namespace octet
