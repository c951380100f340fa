// SPDX-License-Identifier: BSD-3-Clause
// Solids that closed shells bound.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace octet {

/// Solids of the closed shells of `shape` that are in no solid, turned outwards; a face in no shell that
/// closes by itself, as a ball's in IGES files, counts as one. A shell that lies within another, and is
/// turned the other way than the smallest one that it lies in, is a void of that one's solid; one that is
/// turned the same way is a solid of its own. In the order of their shells.
[[nodiscard]] std::vector<TopoDS_Shape> solids_from_shells(const TopoDS_Shape& shape);

/// Shells of one solid, and which of them to turn.
struct TurnedShells {
  TopoDS_Shape solid;  ///< with these turned; the one given where there are none
  std::size_t turned = 0;
};

/// The solid with its shells turned such that each bounds the other side than the smallest one that it lies
/// in: a shell within another is a void, whichever way the file turns it, and one within a void is solid.
/// Those that lie in no other stay as they are, and so do open ones: faces embedded in the solid.
[[nodiscard]] TurnedShells turn_nested_shells(const TopoDS_Shape& solid);

/// Shells of the solids beyond the first of each.
[[nodiscard]] std::size_t count_voids(const std::vector<TopoDS_Shape>& solids);

}  // namespace octet
