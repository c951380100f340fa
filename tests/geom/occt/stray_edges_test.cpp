// SPDX-License-Identifier: BSD-3-Clause
// Edges that run beside the faces that they bound are drawn anew where these meet.
#include "geom/occt/stray_edges.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Vec.hxx>
#include <vector>

#include "geom/model_check.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/from_shape.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kGap = 0.05, kSide = 10.0;

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_EDGE, map);
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= map.Extent(); ++i) edges.push_back(TopoDS::Edge(map(i).Oriented(TopAbs_FORWARD)));
  return edges;
}

/// Moves an edge and its ends, under a tolerance that covers it, and nothing else.
void move_edge(const TopoDS_Edge& edge, const gp_Vec& by) {
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const BRep_Builder builder;
  const double tolerance = 2.0 * by.Magnitude();
  builder.UpdateEdge(edge, Handle(Geom_Curve)::DownCast(curve->Translated(by)), tolerance);
  for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    builder.UpdateVertex(v, BRep_Tool::Pnt(v).Translated(by), tolerance);
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(kSide, kSide, kSide).Shape(); }

/// All edges on their faces, all vertices on the ends of their edges.
void expect_tight(const TopoDS_Shape& shape, double within) {
  EXPECT_LT(widest_curve_gap(shape), within);
  for (const TopoDS_Edge& edge : edges_of(shape)) {
    if (BRep_Tool::Degenerated(edge)) continue;
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    EXPECT_LT(BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Distance(curve->Value(first)), within);
    EXPECT_LT(BRep_Tool::Pnt(TopExp::LastVertex(edge)).Distance(curve->Value(last)), within);
    EXPECT_LT(BRep_Tool::Tolerance(edge), 10.0 * within);
    EXPECT_LT(BRep_Tool::Tolerance(TopExp::FirstVertex(edge)), 10.0 * within);
  }
}

TEST(StrayEdges, OfABoxGoBackToItsCorners) {
  const TopoDS_Shape shape = box();
  const TopoDS_Edge edge = edges_of(shape).front();
  move_edge(edge, gp_Vec(kGap, 2.0 * kGap, -kGap));
  const auto redrawn = redraw_stray_edges({shape});
  ASSERT_EQ(redrawn.size(), 1u);
  EXPECT_TRUE(redrawn.front().edge.IsSame(edge));
  EXPECT_NEAR(redrawn.front().gap, 2.0 * kGap, 1e-9);  // from the face that is the farther
  expect_tight(shape, 1e-6);
  for (const TopoDS_Edge& e : edges_of(shape)) {
    const gp_Pnt at = BRep_Tool::Pnt(TopExp::FirstVertex(e));
    for (const double x : {at.X(), at.Y(), at.Z()})
      EXPECT_LT(std::min(std::abs(x), std::abs(x - kSide)), 1e-7);
  }
  EXPECT_TRUE(redraw_stray_edges({shape}).empty());
}

TEST(StrayEdges, AroundACylinderFollowIt) {
  constexpr double kRadius = 2.0;
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(kRadius, kSide).Shape();
  const BRep_Builder builder;
  for (const TopoDS_Edge& edge : edges_of(shape)) {  // its rims become wider, as do the plane faces' curves
    double first = 0.0, last = 0.0;
    const Handle(Geom_Circle) circle = Handle(Geom_Circle)::DownCast(BRep_Tool::Curve(edge, first, last));
    if (circle.IsNull()) continue;
    const gp_Circ wider(circle->Position(), kRadius + kGap);
    builder.UpdateEdge(edge, new Geom_Circle(wider), 2.0 * kGap);
    const TopoDS_Vertex v = TopExp::FirstVertex(edge);
    builder.UpdateVertex(v, wider.Location().Translated(gp_Vec(kRadius + kGap, 0.0, 0.0)), 2.0 * kGap);
  }
  ASSERT_GT(widest_curve_gap(shape), 0.9 * kGap);
  EXPECT_EQ(redraw_stray_edges({shape}).size(), 2u);
  expect_tight(shape, 1e-5);
}

TEST(StrayEdges, BetweenCurvedFacesAreDrawnWhereTheyMeet) {
  const gp_Ax2 askew(gp_Pnt(2.0, 3.0, -5.0), gp_Dir(0.3, 0.2, 1.0));
  const TopoDS_Shape bar =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5.0, -5.0, 5.0), gp_Dir(0, 1, 0)), 4.0, 20.0);
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(bar, BRepPrimAPI_MakeCylinder(askew, 2.0, 30.0)).Shape();
  int moved = 0;
  for (const TopoDS_Edge& edge : edges_of(shape)) {
    double first = 0.0, last = 0.0;
    if (Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last)).IsNull()) continue;
    move_edge(edge, gp_Vec(kGap, kGap, 0.0));
    ++moved;
  }
  ASSERT_GE(moved, 2);
  EXPECT_EQ(redraw_stray_edges({shape}).size(), static_cast<std::size_t>(moved));
  expect_tight(shape, 1e-5);
}

TEST(StrayEdges, BetweenFacesOfOneSurfaceGoToIt) {
  const gp_Ax2 above(gp_Pnt(0.0, 0.0, kSide), gp::DZ());
  BRepAlgoAPI_Fuse fuse(BRepPrimAPI_MakeCylinder(2.0, kSide).Shape(),
                        BRepPrimAPI_MakeCylinder(above, 2.0, kSide).Shape());
  const TopoDS_Shape shape = fuse.Shape();
  int widened = 0;
  for (const TopoDS_Edge& edge : edges_of(shape)) {
    double first = 0.0, last = 0.0;
    const Handle(Geom_Circle) circle = Handle(Geom_Circle)::DownCast(BRep_Tool::Curve(edge, first, last));
    if (circle.IsNull() || std::abs(circle->Location().Z() - kSide) > 1e-9) continue;
    BRep_Builder().UpdateEdge(edge, new Geom_Circle(circle->Position(), 2.0 + kGap), 2.0 * kGap);
    ++widened;
  }
  ASSERT_EQ(widened, 1);
  EXPECT_EQ(redraw_stray_edges({shape}).size(), 1u);
  expect_tight(shape, 1e-5);
}

TEST(StrayEdges, OfFacesThatAreTangentStay) {
  const TopoDS_Shape sharp = box();
  BRepFilletAPI_MakeFillet fillet(sharp);
  fillet.Add(2.0, edges_of(sharp).front());
  const TopoDS_Shape shape = fillet.Shape();
  TopoDS_Edge tangent;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    if (!Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(face.Current()))).IsNull()) continue;
    for (const TopoDS_Edge& edge : edges_of(face.Current())) {
      double first = 0.0, last = 0.0;
      if (!Handle(Geom_Line)::DownCast(BRep_Tool::Curve(edge, first, last)).IsNull()) tangent = edge;
    }
  }
  ASSERT_FALSE(tangent.IsNull());
  move_edge(tangent, gp_Vec(kGap, kGap, kGap));
  const double gap = widest_curve_gap(shape);
  EXPECT_TRUE(redraw_stray_edges({shape}).empty());
  EXPECT_EQ(widest_curve_gap(shape), gap);
}

/// An edge at one of its ends that ends short of the corner, and whose curves on its faces go no farther: it
/// cannot follow, so that all stays.
TEST(StrayEdges, WhoseNeighbourCannotFollowStayWithTheirVertices) {
  const TopoDS_Shape shape = box();
  const TopoDS_Edge stray = edges_of(shape).front();
  const TopoDS_Vertex corner = TopExp::FirstVertex(stray);
  for (const TopoDS_Edge& edge : edges_of(shape)) {
    const bool begins = TopExp::FirstVertex(edge).IsSame(corner);
    if (edge.IsSame(stray) || !(begins || TopExp::LastVertex(edge).IsSame(corner))) continue;
    double first = 0.0, last = 0.0;
    BRep_Tool::Range(edge, first, last);
    (begins ? first : last) += begins ? kGap : -kGap;
    const BRep_Builder builder;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      double from = 0.0, to = 0.0;
      const Handle(Geom2d_Curve) curve =
          BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Current()), from, to);
      if (!curve.IsNull())
        builder.UpdateEdge(edge, new Geom2d_TrimmedCurve(curve, first, last), TopoDS::Face(face.Current()),
                           2.0 * kGap);
    }
    builder.Range(edge, first, last);
    break;
  }
  move_edge(stray, gp_Vec(kGap, kGap, kGap));
  std::vector<gp_Pnt> before;
  for (const TopoDS_Edge& edge : edges_of(shape)) before.push_back(BRep_Tool::Pnt(TopExp::FirstVertex(edge)));
  EXPECT_TRUE(redraw_stray_edges({shape}).empty());
  for (const TopoDS_Edge& edge : edges_of(shape)) {
    EXPECT_EQ(BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Distance(before.front()), 0.0);
    before.erase(before.begin());
  }
}

TEST(StrayEdges, ThatAreNearEnoughStay) {
  const TopoDS_Shape shape = box();
  move_edge(edges_of(shape).front(), gp_Vec(1e-3, 1e-3, 1e-3));
  EXPECT_TRUE(redraw_stray_edges({shape}).empty());
}

TEST(StrayEdges, AreToldAndTheModelIsRight) {
  const TopoDS_Shape shape = box();
  move_edge(edges_of(shape).front(), gp_Vec(kGap, kGap, kGap));
  const Model model = model_from_shape(shape);
  EXPECT_TRUE(has_note(model, "1 edge(s) ran up to 0.05 mm beside their faces"));
  EXPECT_NEAR(model.region(1).volume, kSide * kSide * kSide, 1e-6);
  EXPECT_TRUE(check_model(model).empty());
}

}  // namespace
}  // namespace octet::test
