// SPDX-License-Identifier: BSD-3-Clause
// Faces that different solids have alike.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <set>
#include <vector>

namespace octet {

/// Edges of two faces that are one another, and whether they run alike.
struct LikeEdges {
  TopoDS_Edge kept, other;
  bool along = true;
};

struct LikeFaces {
  TopoDS_Face kept, other;  ///< as their solids turn them
  std::size_t kept_solid = 0, solid = 0;
  bool same_side = true;  ///< whether their normals look the same way
  std::vector<LikeEdges> edges;
};

/// Each face that is like one of a solid before its own, with the first such, in the order of the solids:
/// vertices, edges and places on the faces are no farther apart than their tolerances say, and than
/// kRoundingShare of the smaller solid's diagonal. Solids in `out` have none.
[[nodiscard]] std::vector<LikeFaces> like_faces(const std::vector<TopoDS_Shape>& solids,
                                                const std::set<std::size_t>& out);

}  // namespace octet
