// SPDX-License-Identifier: BSD-3-Clause
// How far curves on faces are from their edges, and tolerances that cover no more than that.
#include "geom/occt/curve_gaps.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

namespace octet {
namespace {

constexpr int kGapSamples = 24;
constexpr double kReserve = 1.05;  // for what lies between the samples

/// What the edges that end at a vertex need it to cover.
double needed_at(const TopoDS_Shape& vertex, const TopTools_ListOfShape& edges) {
  const gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(vertex));
  double needed = Precision::Confusion();
  for (const TopoDS_Shape& shape : edges) {
    const TopoDS_Edge& edge = TopoDS::Edge(shape);
    needed = std::max(needed, BRep_Tool::Tolerance(edge));
    double t0 = 0.0, t1 = 0.0;
    const auto curve = BRep_Tool::Curve(edge, t0, t1);
    if (curve.IsNull()) continue;
    if (TopExp::FirstVertex(edge).IsSame(vertex))
      needed = std::max(needed, kReserve * at.Distance(curve->Value(t0)));
    if (TopExp::LastVertex(edge).IsSame(vertex))
      needed = std::max(needed, kReserve * at.Distance(curve->Value(t1)));
  }
  return needed;
}

}  // namespace

double curve_gap(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double t0 = 0.0, t1 = 0.0, s0 = 0.0, s1 = 0.0;
  const auto curve = BRep_Tool::Curve(edge, t0, t1);
  const auto on_face = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
  if (curve.IsNull() || on_face.IsNull()) return 0.0;
  const auto surface = BRep_Tool::Surface(face);
  double gap = 0.0;
  for (int i = 0; i <= kGapSamples; ++i) {
    const double share = static_cast<double>(i) / kGapSamples;
    const gp_Pnt2d uv = on_face->Value(s0 + share * (s1 - s0));
    gap = std::max(gap, surface->Value(uv.X(), uv.Y()).Distance(curve->Value(t0 + share * (t1 - t0))));
  }
  return gap;
}

double widest_curve_gap(const TopoDS_Shape& shape) {
  double widest = 0.0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
      widest = std::max(widest, curve_gap(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current())));
  return widest;
}

void lower_tolerances(const TopoDS_Shape& solid, const std::vector<TopoDS_Edge>& edges) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_at, edges_at;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_at);
  TopExp::MapShapesAndAncestors(solid, TopAbs_VERTEX, TopAbs_EDGE, edges_at);
  const ShapeFix_ShapeTolerance tolerance;
  TopTools_MapOfShape vertices;
  for (const TopoDS_Edge& edge : edges) {
    double needed = Precision::Confusion();
    for (const TopoDS_Shape& face : faces_at.FindFromKey(edge))
      needed = std::max(needed, kReserve * curve_gap(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD))));
    tolerance.SetTolerance(edge, needed, TopAbs_EDGE);
    for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) vertices.Add(v);
  }
  for (TopTools_MapOfShape::Iterator it(vertices); it.More(); it.Next())
    tolerance.SetTolerance(it.Value(), needed_at(it.Value(), edges_at.FindFromKey(it.Value())),
                           TopAbs_VERTEX);
}

}  // namespace octet
