// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces of another place than their edges are made anew; those whole turns apart are joined.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
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
#include <TopoDS_Wire.hxx>
#include <gp_Vec2d.hxx>

#include "base/constants.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

/// The spline through three points.
Handle(Geom_BSplineCurve) spline_through(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 3);
  points->SetValue(1, a);
  points->SetValue(2, b);
  points->SetValue(3, c);
  GeomAPI_Interpolate spline(points, false, 1e-9);
  spline.Perform();
  return spline.Curve();
}

/// A bellied ring: its outside is a spline turned about the z axis.
TopoDS_Shape belly(double angle) {
  const gp_Pnt a(2.0, 0.0, 0.0), b(2.1, 0.0, 2.0), c(1.0, 0.0, 2.0), d(1.0, 0.0, 0.0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(spline_through(a, gp_Pnt(2.6, 0.0, 1.0), b)).Edge(),
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

/// An edge that passes for a pole, along a line of v of the face, from `start` once around.
TopoDS_Edge false_pole(const TopoDS_Face& face, const gp_Pnt2d& start, const TopoDS_Vertex& vertex) {
  const BRep_Builder builder;
  TopoDS_Edge pole;
  builder.MakeEdge(pole);
  builder.UpdateEdge(pole, new Geom2d_Line(start, gp_Dir2d(1.0, 0.0)), face, 1e-7);
  builder.Range(pole, face, 0.0, 2.0 * M_PI);
  builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
  builder.Degenerated(pole, true);
  return pole;
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
    wire.Free(true);
    BRep_Builder().Add(wire, false_pole(face, start, TopExp::FirstVertex(beside)));
    return true;
  }
  return false;
}

constexpr double kLow = 2.0, kHigh = 1.0, kHeight = 3.0;

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
      builder.Add(wire, false_pole(face, gp_Pnt2d(upper ? 0.0 : -kTurn, v), vertex)
                            .Oriented(upper ? TopAbs_REVERSED : TopAbs_FORWARD));
      builder.UpdateVertex(vertex, 2.0 * kLow);
    }
  }
  return cone;
}

void expect_as_before(const Model& whole, const TopoDS_Shape& shape, const char* note) {
  const Model model = model_from_shape(shape);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, whole.region(1).volume, 1e-6 * whole.region(1).volume);
  ASSERT_EQ(model.count(2), whole.count(2));
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_NEAR(model.face(f).area, whole.face(f).area, 1e-6 * whole.face(f).area);
  EXPECT_TRUE(has_note(model, note));
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

TEST(MisplacedCurves, ALoopOfTwoTurnsUnderWideTolerancesIsJoined) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(kLow, kHigh, kHeight).Shape();
  expect_as_before(model_from_shape(cone), wound_cone(), "whole turns apart");
  EXPECT_EQ(check_model(model_from_shape(wound_cone())), "");
}

/// A cylinder whose lower circle is a little too high on its face, as wide tolerances allow: the loop is open
/// where the seam ends.
TopoDS_Shape gapped_cylinder(double gap) {
  const BRep_Builder builder;
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(kLow, kHeight).Shape();
  const TopTools_IndexedMapOfShape faces = sub_shapes(shape, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
    if (edges.Extent() != 3) continue;  // a plane
    for (int k = 1; k <= edges.Extent(); ++k) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges(k));
      double first = 0.0, last = 0.0;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
      if (BRep_Tool::IsClosed(edge, face) || curve->Value(first).Y() > 0.5 * kHeight) continue;
      builder.UpdateEdge(edge, Handle(Geom2d_Curve)::DownCast(curve->Translated(gp_Vec2d(0.0, gap))), face,
                         2.0 * gap);
      builder.UpdateVertex(TopExp::FirstVertex(edge), 2.0 * gap);
    }
  }
  return shape;
}

TEST(MisplacedCurves, ASeamDoesNotTurnBackWhereItsLoopIsOpen) {
  const Model whole = model_from_shape(BRepPrimAPI_MakeCylinder(kLow, kHeight).Shape());
  const Model model = model_from_shape(gapped_cylinder(0.02));
  ASSERT_EQ(model.count(2), 3);
  EXPECT_FALSE(has_note(model, "whole turns apart"));
  EXPECT_NEAR(model.region(1).volume, whole.region(1).volume, 1e-6 * whole.region(1).volume);
  EXPECT_EQ(check_model(model), "");
}

int count_poles(const Model& model) {
  int poles = 0;
  for (int e = 1; e <= model.count(1); ++e) poles += model.edge(e).use == EdgeUse::kDegenerate ? 1 : 0;
  return poles;
}

TEST(MisplacedCurves, ATruePoleStays) {
  EXPECT_EQ(count_poles(model_from_shape(BRepPrimAPI_MakeCone(kLow, 0.0, kHeight).Shape())), 1);
}

/// A dome whose profile misses the axis it is turned about, as in a file of few digits.
TopoDS_Shape dome(double missed) {
  const gp_Pnt rim(40.0, 0.0, 0.0), top(0.0, 0.0, 50.0), foot(0.0, 0.0, 0.0);
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(spline_through(rim, gp_Pnt(32.0, 0.0, 30.0), top)).Edge(),
      BRepBuilderAPI_MakeEdge(top, foot).Edge(), BRepBuilderAPI_MakeEdge(foot, rim).Edge());
  const TopoDS_Shape shape =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Ax1(foot, gp_Dir(0, 0, 1)))
          .Shape();
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(faces.Current()));
    if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !turned.IsNull())
      turned->SetLocation(gp_Pnt(0.0, missed, 0.0));
  }
  return shape;
}

TEST(MisplacedCurves, APoleThatRoundingTookOffItsAxisStays) {
  const Model exact = model_from_shape(dome(0.0)), off = model_from_shape(dome(7e-6));
  EXPECT_EQ(count_poles(off), 1);
  EXPECT_EQ(off.count(2), exact.count(2));
  EXPECT_NEAR(off.region(1).volume, exact.region(1).volume, 1e-5 * exact.region(1).volume);
}

}  // namespace
}  // namespace octet::test
