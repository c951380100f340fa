// SPDX-License-Identifier: BSD-3-Clause
// Edges cut at vertices.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Vertex.hxx>

#include <map>
#include <vector>

#include "geom/occt/repair.h"

namespace octet {

/// A vertex on an edge, between its ends.
struct Cut {
  double parameter = 0.0;  ///< on the edge
  double distance = 0.0;   ///< of the vertex from it
  TopoDS_Vertex vertex;
};

/// Where edges are to be cut, by their numbers in a map of the solid's edges.
class EdgeCuts {
 public:
  /// Each vertex and each parameter of an edge counts once.
  void add(int edge, const Cut& cut);
  /// The solid with these edges in pieces that share the vertices, whose tolerances then cover the distances;
  /// `entities` are the edges.
  [[nodiscard]] Repair apply(const TopoDS_Shape& solid, const TopTools_IndexedMapOfShape& edges) const;

 private:
  std::map<int, std::vector<Cut>> cuts_;  ///< ascending along the edge
};

}  // namespace octet
