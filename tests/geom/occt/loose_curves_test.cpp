// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces that run beside their edges are fitted anew, and the tolerance that covered the gap goes.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Vec.hxx>
#include <vector>

#include "geom/model_check.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/loose_curves.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kRadius = 2.0, kHeight = 10.0, kWide = 0.05;

struct Use {
  TopoDS_Edge edge;
  TopoDS_Face face;
};

/// Edges on curved faces that are neither seams nor poles.
std::vector<Use> curved_uses(const TopoDS_Shape& shape) {
  std::vector<Use> uses;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (!Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face)).IsNull()) continue;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
      if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face)) uses.push_back({edge, face});
    }
  }
  return uses;
}

/// Puts a spline through every fifth of the curve in its place, as a reader does that is easily content: it
/// ends where the curve does. Returns how many are farther than `least` from their edges by that.
int make_coarse(const TopoDS_Shape& shape, double least) {
  constexpr int kPieces = 5;
  constexpr double kOff = 0.01;
  const BRep_Builder builder;
  int coarse = 0;
  for (const auto& [edge, face] : curved_uses(shape)) {
    double first = 0.0, last = 0.0;
    const auto curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, kPieces + 1);
    const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, kPieces + 1);
    for (int i = 0; i <= kPieces; ++i) {
      const double t = first + (last - first) * i / kPieces;
      const gp_Pnt2d uv = curve->Value(t);
      const double off = i == 0 || i == kPieces ? 0.0 : (i % 2 == 0 ? kOff : -kOff);
      points->SetValue(i + 1, gp_Pnt2d(uv.X() + off, uv.Y() + off));
      parameters->SetValue(i + 1, t);
    }
    Geom2dAPI_Interpolate spline(points, parameters, false, 1e-9);
    spline.Perform();
    builder.UpdateEdge(edge, spline.Curve(), face, kWide);
    builder.Range(edge, face, first, last);
    for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
      builder.UpdateVertex(v, kWide);
    coarse += curve_gap(edge, face) > least ? 1 : 0;
  }
  return coarse;
}

/// A bar of a quarter of a disc, cut askew.
TopoDS_Shape askew_bar() {
  const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(kRadius, kHeight, M_PI_2).Shape();
  const gp_Ax2 askew(gp_Pnt(-20.0, -20.0, 16.0), gp_Dir(0.3, 0.2, 1.0), gp_Dir(1.0, 0.0, -0.3));
  return BRepAlgoAPI_Cut(bar, BRepPrimAPI_MakeBox(askew, 60.0, 60.0, 60.0).Shape()).Shape();
}

TopoDS_Shape ball_octant() { return BRepPrimAPI_MakeSphere(kRadius, 0.0, M_PI_2, M_PI_2).Shape(); }

void expect_fitted(const TopoDS_Shape& right, const TopoDS_Shape& shape) {
  const Model whole = model_from_shape(right);
  const int coarse = make_coarse(shape, 1e-3);
  ASSERT_GT(coarse, 0);
  const Model model = model_from_shape(shape);
  EXPECT_TRUE(has_note(model, "ran beside their edges"));
  EXPECT_EQ(check_model(model), "");
  ASSERT_EQ(model.count(2), whole.count(2));
  EXPECT_NEAR(model.region(1).volume, whole.region(1).volume, 1e-5 * whole.region(1).volume);
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_NEAR(model.face(f).area, whole.face(f).area, 1e-5 * whole.face(f).area);
  EXPECT_GE(static_cast<int>(fit_loose_curves(shape, 1e-6).size()), coarse);
  for (const auto& [edge, face] : curved_uses(shape)) {
    EXPECT_LT(curve_gap(edge, face), 2e-6);
    EXPECT_LT(BRep_Tool::Tolerance(edge), 1e-5);
    EXPECT_LT(BRep_Tool::Tolerance(TopExp::FirstVertex(edge)), 1e-5);
  }
}

TEST(LooseCurves, AreFittedAnew) { expect_fitted(askew_bar(), askew_bar()); }

TEST(LooseCurves, AreFittedAnewOnSplines) {
  const auto splines = [] { return BRepBuilderAPI_NurbsConvert(askew_bar(), true).Shape(); };
  expect_fitted(splines(), splines());
}

TEST(LooseCurves, AreFittedAnewUpToAPole) { expect_fitted(ball_octant(), ball_octant()); }

TEST(LooseCurves, ThatLieOnTheirEdgesStay) {
  for (const TopoDS_Shape& shape : {askew_bar(), ball_octant()}) {
    ASSERT_FALSE(curved_uses(shape).empty());
    EXPECT_TRUE(fit_loose_curves(shape, 1e-6).empty());
    for (const auto& [edge, face] : curved_uses(shape)) EXPECT_FALSE(fit_curve(edge, face));
  }
}

TEST(LooseCurves, OfAFaceNoWiderThanTheyAreOffStay) {
  constexpr double kLow = 0.05;
  const TopoDS_Shape coin = BRepPrimAPI_MakeCylinder(kRadius, kLow, M_PI_2).Shape();
  ASSERT_GT(make_coarse(coin, 0.25 * kLow), 0);
  EXPECT_TRUE(fit_loose_curves(coin, 1e-6).empty());
  for (const auto& [edge, face] : curved_uses(coin)) EXPECT_GE(BRep_Tool::Tolerance(edge), kWide);
}

TEST(LooseCurves, OfEdgesBesideTheirFaceStay) {
  const TopoDS_Shape shape = askew_bar();
  const BRep_Builder builder;
  int moved = 0;
  for (const auto& [edge, face] : curved_uses(shape)) {
    double first = 0.0, last = 0.0;
    const auto curve = BRep_Tool::Curve(edge, first, last);
    builder.UpdateEdge(edge, Handle(Geom_Curve)::DownCast(curve->Translated(gp_Vec(0.01, 0.01, 0.0))), kWide);
    moved += curve_gap(edge, face) > 5e-3 ? 1 : 0;
  }
  ASSERT_GT(moved, 0);
  for (const auto& [edge, face] : curved_uses(shape)) {
    const double gap = curve_gap(edge, face);
    EXPECT_FALSE(fit_curve(edge, face));
    EXPECT_EQ(curve_gap(edge, face), gap);
  }
}

}  // namespace
}  // namespace octet::test
