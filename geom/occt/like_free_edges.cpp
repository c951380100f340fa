// SPDX-License-Identifier: BSD-3-Clause
// Pairs are looked for among the edges of the same vertices.
#include "geom/occt/like_free_edges.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <optional>
#include <vector>

#include "geom/occt/free_edges.h"
#include "geom/occt/same_place.h"

namespace octet {
namespace {

bool same_ends(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Vertex a0 = TopExp::FirstVertex(a), a1 = TopExp::LastVertex(a), b0 = TopExp::FirstVertex(b),
                      b1 = TopExp::LastVertex(b);
  if (a0.IsNull() || a1.IsNull() || b0.IsNull() || b1.IsNull()) return false;
  return (a0.IsSame(b0) && a1.IsSame(b1)) || (a0.IsSame(b1) && a1.IsSame(b0));
}

}  // namespace

std::size_t join_like_free_edges(const TopoDS_Shape& shape, double near, BRepTools_ReShape& changes) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of, edges_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  const std::vector<TopoDS_Edge> edges = free_edges(shape);
  for (const TopoDS_Edge& edge : edges)
    TopExp::MapShapesAndUniqueAncestors(edge.Oriented(TopAbs_FORWARD), TopAbs_VERTEX, TopAbs_EDGE, edges_of);
  const BRep_Builder builder;
  TopTools_MapOfShape done;
  std::size_t pairs = 0;
  for (const TopoDS_Edge& edge : edges) {
    const TopoDS_Edge kept = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex start = TopExp::FirstVertex(kept);
    if (start.IsNull() || done.Contains(kept)) continue;
    for (const TopoDS_Shape& there : edges_of.FindFromKey(start)) {
      const TopoDS_Edge other = TopoDS::Edge(there);
      const TopoDS_Face face = TopoDS::Face(faces_of.FindFromKey(other).First());
      if (done.Contains(other) || faces_of.FindFromKey(kept).First().IsSame(face) || !same_ends(kept, other))
        continue;
      const std::optional<bool> along = same_way(kept, other, near);
      if (!along) continue;
      builder.UpdateEdge(kept, std::max(near, BRep_Tool::Tolerance(other)));
      take_curve(other, face, kept, *along);
      changes.Replace(other, kept.Oriented(*along ? TopAbs_FORWARD : TopAbs_REVERSED));
      done.Add(kept);
      done.Add(other);
      ++pairs;
      break;
    }
  }
  return pairs;
}

}  // namespace octet
