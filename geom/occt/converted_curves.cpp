// SPDX-License-Identifier: BSD-3-Clause
// Gaps in every span of a curve, and curves fitted from those on the old faces.
#include "geom/occt/converted_curves.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <vector>

#include "geom/occt/curve_gaps.h"
#include "geom/occt/loose_curves.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// curve_gap, and the gap in the middle of every span of a spline: that in which a curve runs from one side
/// of a seam to the other may lie between two samples.
double gap_of_every_span(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double gap = curve_gap(edge, face);
  double t0 = 0.0, t1 = 0.0, s0 = 0.0, s1 = 0.0;
  const auto curve = BRep_Tool::Curve(edge, t0, t1);
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(BRep_Tool::CurveOnSurface(edge, face, s0, s1));
  if (curve.IsNull() || spline.IsNull()) return gap;
  const auto surface = BRep_Tool::Surface(face);
  for (int k = 1; k < spline->NbKnots(); ++k) {
    const double s = 0.5 * (std::max(spline->Knot(k), s0) + std::min(spline->Knot(k + 1), s1));
    if (s < s0 || s > s1) continue;
    const gp_Pnt2d uv = spline->Value(s);
    const gp_Pnt point = curve->Value(t0 + (s - s0) / (s1 - s0) * (t1 - t0));
    gap = std::max(gap, surface->Value(uv.X(), uv.Y()).Distance(point));
  }
  return gap;
}

bool is_used(const TopoDS_Edge& edge, const TopoDS_Face& face, TopAbs_Orientation way) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().IsSame(edge) && it.Current().Orientation() == way) return true;
  return false;
}

Handle(Geom2d_Curve) curve_on(const TopoDS_Edge& edge, const TopoDS_Face& face, double& first, double& last) {
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) throw Standard_Failure("an edge has no curve on its face");
  return curve;
}

}  // namespace

void carry_curve(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Edge& made,
                 const TopoDS_Face& made_face) {
  const BRep_Builder builder;
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) there = curve_on(edge, face, first, last);
  const Handle(Geom2d_Curve) back = curve_on(TopoDS::Edge(edge.Reversed()), face, first, last);
  const bool is_back = is_used(edge, face, TopAbs_REVERSED);
  if (BRep_Tool::IsClosed(edge, face) && is_back && is_used(edge, face, TopAbs_FORWARD))
    builder.UpdateEdge(made, there, back, made_face, Precision::Confusion());
  else
    builder.UpdateEdge(made, is_back ? back : there, made_face, Precision::Confusion());
  builder.Range(made, made_face, first, last);
  fit_curve(made, made_face);
}

void mend_conversion(const TopoDS_Shape& solid, BRepBuilderAPI_NurbsConvert& convert, double noise) {
  static_cast<void>(fit_loose_curves(convert.ModifiedShape(solid), noise));
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face old = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    const TopoDS_Face face = TopoDS::Face(convert.ModifiedShape(old).Oriented(TopAbs_FORWARD));
    const TopTools_IndexedMapOfShape edges = sub_shapes(old, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, old)) continue;
      const TopoDS_Edge made = TopoDS::Edge(convert.ModifiedShape(edge).Oriented(TopAbs_FORWARD));
      if (gap_of_every_span(made, face) > noise) carry_curve(edge, old, made, face);
    }
  }
}

bool lower_tolerances_to(const TopoDS_Shape& solid, double allowed) {
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
      if (gap_of_every_span(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current())) > allowed)
        return false;
  std::vector<TopoDS_Edge> wide;
  const TopTools_IndexedMapOfShape edges = sub_shapes(solid, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i)
    if (const TopoDS_Edge edge = TopoDS::Edge(edges(i)); BRep_Tool::Tolerance(edge) > allowed)
      wide.push_back(edge);
  if (!wide.empty()) lower_tolerances(solid, wide);
  return true;
}

}  // namespace octet
