// SPDX-License-Identifier: BSD-3-Clause
// Edges where a shell is open.
#include "geom/occt/free_edges.h"

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "geom/occt/canonical.h"

namespace octet {

std::vector<TopoDS_Edge> free_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
    const TopTools_ListOfShape& faces = faces_of(i);
    if (BRep_Tool::Degenerated(edge) || faces.Extent() != 1) continue;
    if (!BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()))) edges.push_back(edge);
  }
  return edges;
}

std::vector<Vec3> points_along(const TopoDS_Edge& edge, int pieces) {
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  std::vector<Vec3> points;
  for (int i = 0; i <= pieces && !curve.IsNull(); ++i)
    points.push_back(to_vec(curve->Value(first + (last - first) * i / pieces)));
  return points;
}

}  // namespace octet
