// SPDX-License-Identifier: BSD-3-Clause
// A loop that OCCT's reader wound twice around its surface, and hid it under wide tolerances, is unwound.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Vec2d.hxx>

#include <cmath>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi, kLow = 2.0, kHigh = 1.0, kHeight = 3.0;

/// An edge of no length, it says, along the line of v of the face, from u to u + one turn.
TopoDS_Edge degenerate_edge(const TopoDS_Face& face, double u, double v, const TopoDS_Vertex& vertex) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(u, v), gp_Dir2d(1.0, 0.0)), face, 1e-7);
  builder.Range(edge, 0.0, kTurn);
  builder.Degenerated(edge, true);
  builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
  return edge;
}

Handle(Geom2d_Curve) shifted(const Handle(Geom2d_Curve) & curve) {
  return Handle(Geom2d_Curve)::DownCast(curve->Translated(gp_Vec2d(-kTurn, 0.0)));
}

/// A cone whose upper circle and first side of the seam are a turn back in (u,v), with edges of no length
/// that close the loop, which then spans two turns: what OCCT 7.6 reads of some holders of batteries.
TopoDS_Shape wound_cone() {
  const BRep_Builder builder;
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(kLow, kHigh, kHeight).Shape();
  const TopTools_IndexedMapOfShape faces = sub_shapes(cone, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    TopoDS_Wire wire = TopoDS::Wire(TopExp_Explorer(face, TopAbs_WIRE).Current());
    const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
    if (edges.Extent() != 3) continue;  // a plane
    wire.Free(true);
    for (int k = 1; k <= edges.Extent(); ++k) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(k).Oriented(TopAbs_FORWARD));
      const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
      double first = 0.0, last = 0.0;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
      if (BRep_Tool::IsClosed(edge, face)) {
        const Handle(Geom2d_Curve) other =
            BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Reversed()), face, first, last);
        const bool back = curve->Value(first).X() < other->Value(first).X();
        builder.UpdateEdge(edge, back ? shifted(curve) : curve, back ? other : shifted(other), face, 1e-7);
        continue;
      }
      const double v = curve->Value(first).Y();
      const bool upper = BRep_Tool::Pnt(vertex).Z() > 0.5 * kHeight;
      if (upper) builder.UpdateEdge(edge, shifted(curve), face, 1e-7);
      builder.Add(wire, degenerate_edge(face, upper ? 0.0 : -kTurn, v, vertex)
                            .Oriented(upper ? TopAbs_REVERSED : TopAbs_FORWARD));
      builder.UpdateVertex(vertex, 2.0 * kLow);
    }
  }
  return cone;
}

double area_of(const Model& model) {
  double area = 0.0;
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  return area;
}

TEST(WoundLoops, AreUnwound) {
  const Model model = model_from_shape(wound_cone());
  const double pi = std::numbers::pi, slant = std::hypot(kHeight, kLow - kHigh);
  EXPECT_NEAR(area_of(model), pi * (kLow * kLow + kHigh * kHigh + (kLow + kHigh) * slant), 1e-6);
  EXPECT_NEAR(model.region(1).volume, pi * kHeight * (kLow * kLow + kLow * kHigh + kHigh * kHigh) / 3.0,
              1e-6);
  EXPECT_EQ(check_model(model), "");
  bool told = false;
  for (const std::string& note : model.notes())
    told = told || note.find("whole turns apart") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(WoundLoops, ATruePoleStays) {
  const Model model = model_from_shape(BRepPrimAPI_MakeCone(kLow, 0.0, kHeight).Shape());
  int poles = 0;
  for (int e = 1; e <= model.count(1); ++e) poles += model.edge(e).use == EdgeUse::kDegenerate ? 1 : 0;
  EXPECT_EQ(poles, 1);
}

}  // namespace
}  // namespace octet::test
