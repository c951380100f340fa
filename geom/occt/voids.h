// SPDX-License-Identifier: BSD-3-Clause
// Voids that touch the outside of their solid.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct VoidsJoined {
  std::vector<TopoDS_Shape> solids;
  Handle(BRepTools_History) history;
  bool touch = false;  ///< else nothing was changed: `solids` holds the one given
};

/// A shell has edges and vertices of its own, also where it touches another shell of its solid; no mesh can
/// have both. Such entities become one, and where nothing else holds the solid together it becomes several.
/// Shells that cross are left as they are.
[[nodiscard]] VoidsJoined join_voids(const TopoDS_Shape& solid);

}  // namespace octet
