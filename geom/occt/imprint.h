// SPDX-License-Identifier: BSD-3-Clause
// Faces of a solid that touch get the edges and vertices there in common.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <cstddef>
#include <vector>

namespace octet {

struct Imprinted {
  std::vector<TopoDS_Shape> solids;
  Handle(BRepTools_History) history;
  std::size_t joined = 0;  ///< pairs that share an edge or a vertex now; 0: `solids` are those given
  int doubles = 0;         ///< pieces of faces with the same on both sides, which were taken away
};

/// Imprints faces that touch on each other, with the least of some tolerances that joins the most pairs. The
/// rest of the solids stays: their edges and vertices change where those of these faces do. Where pieces of
/// two faces of one solid lie on one another they bound nothing and are taken away. Edges that took the
/// place of others may lack curves on neighbours: the caller adds them.
[[nodiscard]] Imprinted imprint_faces(const std::vector<TopoDS_Shape>& solids,
                                      const std::vector<std::array<TopoDS_Face, 2>>& touching);

}  // namespace octet
