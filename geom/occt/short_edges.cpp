// SPDX-License-Identifier: BSD-3-Clause
// Short edges are found by their length, and dropped by OCCT.
#include "geom/occt/short_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Wireframe.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// The chord first, which nearly all edges fail; a closed edge has none.
bool is_short(const TopoDS_Edge& edge, double length) {
  if (BRep_Tool::Degenerated(edge)) return false;
  const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
               to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
  if (from.Distance(to) > length) return false;
  double first = 0.0, last = 0.0;
  if (BRep_Tool::Curve(edge, first, last).IsNull()) return false;
  try {
    return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)) <= length;
  } catch (const Standard_Failure&) {  // OCCT cannot tell
    return false;
  }
}

}  // namespace

Repair drop_short_edges(const TopoDS_Shape& solid, double length) {
  Repair result = no_repair(solid);
  const TopTools_IndexedMapOfShape edges = sub_shapes(solid, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i)
    if (is_short(TopoDS::Edge(edges(i)), length)) result.entities.push_back(edges(i));
  if (result.entities.empty()) return result;
  const Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
  ShapeFix_Wireframe fix(solid);
  fix.SetContext(context);
  fix.SetPrecision(length);
  fix.ModeDropSmallEdges() = true;
  TopoDS_Shape made = solid;
  try {
    fix.FixSmallEdges();
    made = context->Apply(solid);
  } catch (const Standard_Failure&) {  // of loops that hold an edge twice, among others
  }
  if (sub_shapes(made, TopAbs_FACE).Extent() != sub_shapes(solid, TopAbs_FACE).Extent() ||
      sub_shapes(made, TopAbs_EDGE).Extent() >= edges.Extent()) {
    result.entities.clear();
    return result;
  }
  result.solid = made;
  result.history = context->History();
  return result;
}

}  // namespace octet
