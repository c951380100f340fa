// SPDX-License-Identifier: BSD-3-Clause
// Solids whose faces cross become what they enclose.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <string>
#include <vector>

#include "geom/occt/child_process.h"

namespace octet {

struct United {
  std::vector<TopoDS_Shape> solids;  ///< empty: it could not be done
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> gone;  ///< faces of which nothing is left
  int dropped = 0;                 ///< pieces of faces that bound nothing
  std::string cause;               ///< why it could not be done
};

/// The solids that fill what a solid's boundary goes around once or more (winding_number()), where some of
/// its faces cross: these are cut along each other, and each piece is kept whose outer side has the winding
/// number 0 or less and whose inner side 1 or more. First with the crossing faces alone, then so
/// with a tolerance, then with their neighbours, then with all faces, until the pieces that are kept close.
/// Edges that took the place of others may lack curves on neighbours: the caller adds them.
[[nodiscard]] United unite_crossed(const TopoDS_Shape& solid,
                                   const std::vector<std::array<TopoDS_Face, 2>>& crossing,
                                   const StageLog& log);

}  // namespace octet
