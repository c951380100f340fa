// SPDX-License-Identifier: BSD-3-Clause
// Faces folded flat onto a neighbour.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct FoldsRemoved {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> faces;  ///< that are gone; none: `solid` is the one given
};

/// Takes away every face that turns back at an edge and lies on the face beyond it, no farther than its own
/// edges lie from their faces: the two are one sheet to the file, met from both sides. The other sides of the
/// fold become that face's border. Whether the result is closed is for the caller to test.
[[nodiscard]] FoldsRemoved remove_folds(const TopoDS_Shape& solid);

}  // namespace octet
