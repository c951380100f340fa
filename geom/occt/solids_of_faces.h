// SPDX-License-Identifier: BSD-3-Clause
// Faces that bound solids, sorted into these.
#pragma once

#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

/// The solids that faces bound, which are turned outward and close along their edges: faces that hang
/// together by edges are a lump where their volume is positive, else a void of the smallest lump around it.
/// In the order of the lumps' first faces. Empty: a void lies in no lump.
[[nodiscard]] std::vector<TopoDS_Shape> solids_of_faces(const std::vector<TopoDS_Shape>& faces);

}  // namespace octet
