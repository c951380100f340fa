// SPDX-License-Identifier: BSD-3-Clause
// Edges and vertices that a general fuse leaves where nothing ends.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// Where two faces, or two edges, lie on one another but for rounding, a fuse makes them one, and leaves in
/// it the pieces of lines and the points where it found them to cross: edges inside of one face alone that
/// end nowhere, and vertices inside of edges and faces. Takes those away that the solids did not have.
/// `images`: what became of each solid, by `history`; both are brought up to date.
void drop_loose_parts(const std::vector<TopoDS_Shape>& solids, std::vector<std::vector<TopoDS_Shape>>& images,
                      const Handle(BRepTools_History) & history);

}  // namespace octet
