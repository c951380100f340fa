// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces of another place than their edges are made anew; those whole turns apart are joined.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Vec2d.hxx>

#include "geom/occt/from_shape.h"

namespace octet::test {
namespace {

/// A bellied ring: its outside is a spline turned about the z axis.
TopoDS_Shape belly(double angle) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 3);
  points->SetValue(1, gp_Pnt(2.0, 0.0, 0.0));
  points->SetValue(2, gp_Pnt(2.6, 0.0, 1.0));
  points->SetValue(3, gp_Pnt(2.1, 0.0, 2.0));
  GeomAPI_Interpolate outside(points, false, 1e-9);
  outside.Perform();
  const gp_Pnt a(2.0, 0.0, 0.0), b(2.1, 0.0, 2.0), c(1.0, 0.0, 2.0), d(1.0, 0.0, 0.0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(outside.Curve()).Edge(),
                               BRepBuilderAPI_MakeEdge(b, c).Edge(), BRepBuilderAPI_MakeEdge(c, d).Edge(),
                               BRepBuilderAPI_MakeEdge(d, a).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                               gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle)
      .Shape();
}

/// Moves the curve of one edge, no seam, on the turned spline about the axis. Returns whether there was one.
bool turn_a_curve(const TopoDS_Shape& shape, double angle) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (Handle(Geom_SurfaceOfRevolution)::DownCast(BRep_Tool::Surface(face)).IsNull()) continue;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::IsClosed(edge, face)) continue;
      double s0 = 0.0, s1 = 0.0;
      const auto curve = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
      const BRep_Builder builder;
      builder.UpdateEdge(edge, Handle(Geom2d_Curve)::DownCast(curve->Translated(gp_Vec2d(angle, 0.0))), face,
                         1e-7);
      builder.Range(edge, face, s0, s1);
      return true;
    }
  }
  return false;
}

/// An edge in the first loop on the turned spline that passes for a pole, once around.
bool add_a_false_pole(const TopoDS_Shape& shape) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (Handle(Geom_SurfaceOfRevolution)::DownCast(BRep_Tool::Surface(face)).IsNull()) continue;
    TopExp_Explorer wires(face, TopAbs_WIRE);
    TopoDS_Shape wire = wires.Current();
    const TopoDS_Edge beside = TopoDS::Edge(TopExp_Explorer(wire, TopAbs_EDGE).Current());
    double s0 = 0.0, s1 = 0.0;
    const gp_Pnt2d start = BRep_Tool::CurveOnSurface(beside, face, s0, s1)->Value(s0);
    const TopoDS_Vertex vertex = TopExp::FirstVertex(beside);
    const BRep_Builder builder;
    TopoDS_Edge pole;
    builder.MakeEdge(pole);
    builder.UpdateEdge(pole, new Geom2d_Line(start, gp_Dir2d(1.0, 0.0)), face, 1e-7);
    builder.Range(pole, face, 0.0, 2.0 * M_PI);
    builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
    builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
    builder.Degenerated(pole, true);
    wire.Free(true);
    builder.Add(wire, pole);
    return true;
  }
  return false;
}

void expect_as_before(const Model& whole, const TopoDS_Shape& shape, const char* note) {
  const Model model = model_from_shape(shape);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, whole.region(1).volume, 1e-6 * whole.region(1).volume);
  ASSERT_EQ(model.count(2), whole.count(2));
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_NEAR(model.face(f).area, whole.face(f).area, 1e-6 * whole.face(f).area);
  const auto& notes = model.notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [&](const std::string& text) { return text.find(note) != std::string::npos; }));
}

void expect_as_before(double angle, double turn, const char* note) {
  const TopoDS_Shape shape = belly(angle);
  ASSERT_TRUE(turn_a_curve(shape, turn));
  expect_as_before(model_from_shape(belly(angle)), shape, note);
}

TEST(MisplacedCurves, AreMadeAnewWhereTheEdgeLiesOnTheFace) { expect_as_before(M_PI_2, M_PI, "made anew"); }

TEST(MisplacedCurves, EdgesThatPassForPolesAreTakenOut) {
  const TopoDS_Shape shape = belly(2.0 * M_PI);
  ASSERT_TRUE(add_a_false_pole(shape));
  expect_as_before(model_from_shape(belly(2.0 * M_PI)), shape, "whole turns apart");
}

TEST(MisplacedCurves, WholeTurnsApartAreJoined) {
  expect_as_before(M_PI_2, 4.0 * M_PI, "whole turns apart");
  expect_as_before(2.0 * M_PI, 2.0 * M_PI, "whole turns apart");
}

}  // namespace
}  // namespace octet::test
