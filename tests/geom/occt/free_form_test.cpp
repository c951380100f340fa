// SPDX-License-Identifier: BSD-3-Clause
// Free-form surfaces and curves against the closed forms they stand for.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>

#include "base/constants.h"
#include "geom/arc_length.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/occt_curve.h"
#include "geom/occt/occt_surface.h"
#include "geom/occt/spline_spans.h"
#include "geom/occt/surface_jets.h"

namespace octet {
namespace {

std::shared_ptr<const Surface> nurbs(const Handle(Geom_Surface) & surface, double u0, double u1, double v0,
                                     double v1) {
  const Handle(Geom_Surface) piece = new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1);
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(piece);
  UvCell cell;
  spline->Bounds(cell.lo.x(), cell.hi.x(), cell.lo.y(), cell.hi.y());
  return make_free_form(SurfaceJets(spline), cell);
}

std::shared_ptr<const Surface> nurbs_cylinder() {
  return nurbs(new Geom_CylindricalSurface(gp_Ax3(), 1.0), 0.0, 2.0 * kPi, 0.0, 2.0);
}

std::shared_ptr<const Surface> nurbs_sphere() {
  return nurbs(new Geom_SphericalSurface(gp_Ax3(), 1.0), 0.0, 2.0 * kPi, -0.5 * kPi, 0.5 * kPi);
}

std::vector<SurfaceRoot> roots_of(const Surface& surface, const Vec3& p, const Vec3& q) {
  std::vector<SurfaceRoot> roots;
  surface.intersect(p, q, roots);
  return roots;
}

TEST(FreeForm, LinesJustBelowTangencyCrossACylinderTwice) {
  const auto cylinder = nurbs_cylinder();
  for (const double depth : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
    for (const double z : {0.1234, 0.777, 1.9}) {
      const double y = 1.0 - depth;
      const auto roots = roots_of(*cylinder, {-2.0, y, z}, {2.0, y, z});
      ASSERT_EQ(roots.size(), 2u) << depth << " at " << z;
      const double x = std::sqrt((1.0 - y) * (1.0 + y));
      const double lo = std::min(roots[0].t, roots[1].t), hi = std::max(roots[0].t, roots[1].t);
      EXPECT_NEAR(-2.0 + 4.0 * lo, -x, 1e-12 / x + 1e-12);
      EXPECT_NEAR(-2.0 + 4.0 * hi, x, 1e-12 / x + 1e-12);
    }
}

TEST(FreeForm, ALineThatTouchesIsOneTangentRoot) {
  const auto roots = roots_of(*nurbs_cylinder(), {-2.0, 1.0, 0.77}, {2.0, 1.0, 0.77});
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_TRUE(roots[0].tangent);
  EXPECT_NEAR(roots[0].t, 0.5, 1e-6);
}

TEST(FreeForm, ALineJustOutsideMisses) {
  EXPECT_TRUE(roots_of(*nurbs_cylinder(), {-2.0, 1.0 + 1e-9, 0.77}, {2.0, 1.0 + 1e-9, 0.77}).empty());
}

TEST(FreeForm, ALineInTheSurfaceIsCoincident) {
  const auto roots = roots_of(*nurbs_cylinder(), {0.6, 0.8, 0.5}, {0.6, 0.8, 1.5});
  ASSERT_FALSE(roots.empty());
  for (const SurfaceRoot& root : roots) EXPECT_TRUE(root.coincident);
}

TEST(FreeForm, ALineThroughThePoleOfASphereHitsItOnce) {
  const auto sphere = nurbs_sphere();
  EXPECT_EQ(roots_of(*sphere, {0, 0, 0.5}, {0, 0, 1.5}).size(), 1u);
  EXPECT_EQ(roots_of(*sphere, {0.2, 0.1, 0.0}, {0.2, 0.1, 1.5}).size(), 1u);
  EXPECT_EQ(roots_of(*sphere, {0, 0, -1.5}, {0, 0, 1.5}).size(), 2u);
}

/// Nothing near a spline's end says what its last polynomial is a hundred of its spans beyond it.
TEST(FreeForm, ASplineRunsOnByNoMoreThanItsLastSpanTells) {
  constexpr int kDegree = 9;
  TColgp_Array2OfPnt poles(0, kDegree, 0, kDegree);
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; j <= kDegree; ++j) {
      const double x = i / double(kDegree), y = j / double(kDegree);
      poles(i, j) = gp_Pnt(x, y, 0.1 * std::sin(3.0 * x) * std::cos(2.0 * y));
    }
  const Handle(Geom_BSplineSurface) spline =
      GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles));
  spline->InsertUKnot(1.0 - 1e-5, 1, 1e-12);
  spline->InsertVKnot(1e-5, 1, 1e-12);
  const auto surface = make_free_form(SurfaceJets(spline), UvCell{{0.0, 0.0}, {1.0, 1.0}});
  const gp_Pnt middle = spline->Value(0.5, 0.5);
  const auto roots = roots_of(*surface, {middle.X(), middle.Y(), -1.0}, {middle.X(), middle.Y(), 1.0});
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_NEAR(-1.0 + 2.0 * roots[0].t, middle.Z(), 1e-12);
  EXPECT_NEAR((roots[0].uv - Vec2(0.5, 0.5)).norm(), 0.0, 1e-12);
}

TEST(FreeForm, ProjectionFindsTheFootOnASphere) {
  const auto sphere = nurbs_sphere();
  for (int i = 0; i < 200; ++i) {
    const double a = 0.1 + 0.031 * i, b = -1.3 + 0.013 * i;
    const Vec3 direction(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
    const auto start = roots_of(*sphere, Vec3::Zero(), 2.0 * direction);
    ASSERT_EQ(start.size(), 1u);
    const Vec2 seed = start[0].uv + Vec2(0.05, -0.05);
    const SurfaceFoot foot = sphere->project(1.1 * direction, seed);
    EXPECT_TRUE(foot.converged);
    EXPECT_LT((foot.point - direction).norm(), 1e-9);
  }
}

TEST(FreeForm, ProjectionEndsWhereParametersAreFarFromZero) {
  constexpr double kFar = 5e5;  // digits of the parameter lost: 6e-11
  const auto cylinder = nurbs(new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0.0, 0.0, -kFar), gp::DZ()), 1.0),
                              0.0, kPi, kFar, kFar + 2.0);
  for (const double angle : {0.3, 1.1, 2.9})
    for (const double z : {0.1, 0.77, 1.9})
      for (const double radius : {1.0, 1.001, 0.6}) {
        const Vec3 on(std::cos(angle), std::sin(angle), z);
        const SurfaceFoot foot = cylinder->project({radius * on.x(), radius * on.y(), z}, {1.5, kFar + 1.0});
        EXPECT_TRUE(foot.converged) << angle << " " << z << " " << radius;
        EXPECT_LT((foot.point - on).norm(), 1e-9);
      }
}

TEST(FreeForm, NormalsExistAtThePole) {
  const auto sphere = nurbs_sphere();
  const auto root = roots_of(*sphere, {0.01, 0.02, 0.5}, {0.01, 0.02, 1.5});
  ASSERT_EQ(root.size(), 1u);
  Vec2 pole = root[0].uv;
  pole.y() = root[0].uv.y() + 10.0;  // beyond the range: the projection clamps it to the pole
  pole = sphere->project({0, 0, 1}, {root[0].uv.x(), root[0].uv.y()}).uv;
  EXPECT_GT(std::abs(sphere->normal(pole).z()), 0.999);
}

TEST(FreeForm, SolidsOfSplinesHaveTheVolumeOfTheirQuadrics) {
  const auto volume = [](const TopoDS_Shape& shape) {
    return model_from_shape(BRepBuilderAPI_NurbsConvert(shape, true).Shape()).region(1).volume;
  };
  EXPECT_NEAR(volume(BRepPrimAPI_MakeSphere(10).Shape()), 4000.0 / 3.0 * kPi, 1e-2);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeCylinder(5, 20).Shape()), 500.0 * kPi, 1e-3);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeTorus(20, 5).Shape()), 1000.0 * kPi * kPi, 1e-2);
}

void expect_same_jet(const Geom_Surface& surface, const SurfaceJet& jet, const Vec2& uv, double accuracy) {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface.D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
  const auto error = [](const Vec3& ours, const gp_XYZ& theirs) {
    return (ours - Vec3(theirs.X(), theirs.Y(), theirs.Z())).norm() / (1.0 + ours.norm());
  };
  EXPECT_LT(error(jet.p, p.XYZ()), accuracy);
  EXPECT_LT(error(jet.du, du.XYZ()), 10.0 * accuracy);
  EXPECT_LT(error(jet.dv, dv.XYZ()), 10.0 * accuracy);
  EXPECT_LT(error(jet.duu, duu.XYZ()), 100.0 * accuracy);
  EXPECT_LT(error(jet.duv, duv.XYZ()), 100.0 * accuracy);
  EXPECT_LT(error(jet.dvv, dvv.XYZ()), 100.0 * accuracy);
}

/// 21 by 21 places, none of them on a border.
template <typename Visit>
void for_each_place(const Geom_Surface& surface, const Visit& visit) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      visit(Vec2(u0 + (u1 - u0) * (0.003 + 0.0493 * i), v0 + (v1 - v0) * (0.003 + 0.0493 * j)));
}

Handle(Geom_BSplineSurface) rational_sphere() {
  const Handle(Geom_Surface) sphere = new Geom_RectangularTrimmedSurface(
      new Geom_SphericalSurface(gp_Ax3(), 1.0), 0.0, 2.0 * kPi, -0.5 * kPi, 0.5 * kPi);
  return GeomConvert::SurfaceToBSplineSurface(sphere);
}

Handle(Geom_BSplineSurface) wavy_sheet() {
  TColgp_Array2OfPnt points(1, 7, 1, 6);
  for (int i = 1; i <= 7; ++i)
    for (int j = 1; j <= 6; ++j) points(i, j) = gp_Pnt(i, j, std::sin(1.3 * i) * std::cos(0.9 * j));
  return GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-6).Surface();
}

/// An arc of a wave in the plane y = 0, at x of 2 to 5.
Handle(Geom_BSplineCurve) wavy_arc() {
  TColgp_Array1OfPnt points(1, 7);
  for (int i = 1; i <= 7; ++i) points(i) = gp_Pnt(1.5 + 0.5 * i, 0.0, 0.5 * std::sin(1.3 * i));
  return GeomAPI_PointsToBSpline(points, 4, 6, GeomAbs_C2, 1e-6).Curve();
}

/// What lies between a branch of a hyperbola and a chord, drawn out: its surface has no bounds of its own.
TEST(FreeForm, AHyperbolaDrawnOutIsAskedWithinItsFaceAlone) {
  const Handle(Geom_Hyperbola) hyperbola = new Geom_Hyperbola(gp_Ax2(gp::Origin(), gp::DZ()), 1.0, 1.0);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(hyperbola, -1.0, 1.0);
  const TopoDS_Edge chord = BRepBuilderAPI_MakeEdge(TopExp::FirstVertex(arc), TopExp::LastVertex(arc));
  BRepBuilderAPI_MakeWire border(arc, chord);
  const Model model = model_from_shape(
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire()).Face(), gp_Vec(0, 0, 2)).Shape());
  EXPECT_NEAR(model.region(1).volume, 2.0 * (std::cosh(1.0) * std::sinh(1.0) - 1.0), 1e-9);
  EXPECT_EQ(model.region_at({1.2, 0.1, 1.0}), 1);
  EXPECT_EQ(model.region_at({0.95, 0.1, 1.0}), 0);
}

TEST(SplineSpans, EvaluateAsOcctDoes) {
  Handle(Geom_BSplineSurface) high = wavy_sheet(), highest = wavy_sheet();
  high->IncreaseDegree(6, 11);  // as OCCT makes swept surfaces
  highest->IncreaseDegree(14, 14);
  for (const Handle(Geom_BSplineSurface) & spline : {rational_sphere(), wavy_sheet(), high, highest}) {
    const auto spans = SplineSpans::make(spline);
    ASSERT_TRUE(spans);
    const double accuracy = spline->VDegree() > 10 ? 1e-13 : 1e-14;
    for_each_place(*spline,
                   [&](const Vec2& uv) { expect_same_jet(*spline, spans->evaluate(uv, 2), uv, accuracy); });
  }
}

TEST(SplineSpans, ThirdDerivativesAreOfTheSecondOnes) {
  constexpr double kStep = 1e-5;
  for (const Handle(Geom_BSplineSurface) & spline : {rational_sphere(), wavy_sheet()}) {
    const auto spans = SplineSpans::make(spline);
    ASSERT_TRUE(spans);
    for_each_place(*spline, [&](const Vec2& uv) {
      SurfaceThirds thirds;
      const SurfaceJet jet = spans->evaluate(uv, 3, &thirds);
      EXPECT_EQ(jet.dvv, spans->evaluate(uv, 2).dvv);
      const Vec2 du(kStep, 0.0), dv(0.0, kStep);
      const SurfaceJet east = spans->evaluate(uv + du, 2), west = spans->evaluate(uv - du, 2),
                       north = spans->evaluate(uv + dv, 2), south = spans->evaluate(uv - dv, 2);
      const auto expect_slope = [&](const Vec3& ahead, const Vec3& behind, const Vec3& slope) {
        EXPECT_LT(((ahead - behind) / (2.0 * kStep) - slope).norm(), 1e-4 * (1.0 + slope.norm()));
      };
      expect_slope(east.duu, west.duu, thirds.uuu);
      expect_slope(north.duu, south.duu, thirds.uuv);
      expect_slope(east.dvv, west.dvv, thirds.uvv);
      expect_slope(north.dvv, south.dvv, thirds.vvv);
    });
  }
}

TEST(SplineSpans, PolesThatSwingAreLeftToOcct) {
  TColgp_Array2OfPnt poles(1, 26, 1, 2);
  for (int i = 1; i <= 26; ++i)
    for (int j = 1; j <= 2; ++j) poles(i, j) = gp_Pnt(0.01 * i, j, i / 2 % 2 == 0 ? 1.0 : -1.0);
  const Handle(Geom_Surface) swinging = new Geom_BezierSurface(poles);
  EXPECT_FALSE(SplineSpans::make(swinging));
  const SurfaceJets jets(swinging);
  for_each_place(*swinging,
                 [&](const Vec2& uv) { expect_same_jet(*swinging, jets.evaluate(uv, 2), uv, 1e-15); });
}

TEST(SurfaceJets, OffsetsAreAsOcctHasThem) {
  const Handle(Geom_Curve) wave = wavy_arc();
  const Handle(Geom_Surface) turned =
      new Geom_RectangularTrimmedSurface(new Geom_SurfaceOfRevolution(wave, gp::OZ()), 0.1, 4.0, true);
  const Handle(Geom_Surface) extruded = new Geom_RectangularTrimmedSurface(
      new Geom_SurfaceOfLinearExtrusion(wave, gp_Dir(1, 2, 0.3)), 0.0, 2.0, false);
  for (const Handle(Geom_Surface) & basis :
       {Handle(Geom_Surface)(rational_sphere()), Handle(Geom_Surface)(wavy_sheet()), turned, extruded})
    for (const double distance : {0.05, -0.2}) {
      const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(basis, distance);
      const SurfaceJets jets(offset);
      for_each_place(*offset, [&](const Vec2& uv) {
        expect_same_jet(*offset, jets.evaluate(uv, 2), uv, 1e-12);
        EXPECT_EQ(jets.evaluate(uv, 1).dv, jets.evaluate(uv, 2).dv);
        EXPECT_EQ(jets.evaluate(uv, 0).p, jets.evaluate(uv, 2).p);
        EXPECT_EQ(jets.evaluate(uv, 1).duu, Vec3(Vec3::Zero()));
      });
    }
}

TEST(SurfaceJets, AnOffsetHasItsPoles) {
  const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(rational_sphere(), 0.25);
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  offset->Bounds(u0, u1, v0, v1);
  const SurfaceJets jets(offset);
  for (const double u : {0.3, 1.0, 2.5})
    for (const double off : {0.0, 1e-12, 1e-9, 1e-7, 1e-5}) {
      EXPECT_NEAR(jets.evaluate({u, v0 + off}, 0).p.norm(), 1.25, 1e-9) << off;
      EXPECT_LT((jets.evaluate({u, v1 - off}, 0).p - Vec3(0, 0, 1.25)).norm(), 2.0 * off + 1e-9) << off;
    }
}

std::shared_ptr<const Curve> nurbs_arc() {
  const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2(), 2.0);
  const Handle(Geom_BSplineCurve) spline =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(circle, 0.25, 0.25 + 1.5 * kPi));
  return make_free_curve(CurveJets(Handle(Geom_Curve)(spline)), spline->FirstParameter(),
                         spline->LastParameter());
}

TEST(FreeCurve, CutFindsBothCrossingsAndTheirPlaces) {
  const auto arc = nurbs_arc();
  for (const double y : {1.9, 1.99, 1.9999, 1.999999}) {
    std::vector<double> parameters;
    arc->cut(Vec3::UnitY(), y, parameters);
    ASSERT_EQ(parameters.size(), 2u) << y;
    for (const double t : parameters) EXPECT_NEAR(arc->point(t).y(), y, 1e-12);
  }
  std::vector<double> none;
  arc->cut(Vec3::UnitY(), 2.0 + 1e-9, none);
  EXPECT_TRUE(none.empty());
}

TEST(FreeCurve, TheLengthHasTheShortestOfKnotSpans) {
  // A line that turns back within a thousandth of its parameters, as a CAD system wrote it.
  TColgp_Array1OfPnt poles(1, 7);
  const double x[] = {0.0, 0.0002, 0.0008, 0.0005, 0.2, 0.3, 0.5};
  for (int i = 1; i <= 7; ++i) poles(i) = gp_Pnt(x[i - 1], 0.0, 0.0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  knots(1) = 0.0, knots(2) = 0.0005, knots(3) = 0.5;
  multiplicities(1) = 4, multiplicities(2) = 3, multiplicities(3) = 4;
  const Handle(Geom_Curve) spline = new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  const auto curve = make_free_curve(CurveJets(spline), 0.0, 0.5);
  double chords = 0.0;
  for (int i = 0; i < 100000; ++i) {
    // Half of them in the short span.
    const auto at = [](int k) { return k <= 50000 ? 1e-8 * k : 0.0005 + 0.4995 * (k - 50000) / 50000.0; };
    chords += (curve->point(at(i + 1)) - curve->point(at(i))).norm();
  }
  EXPECT_GT(chords, 0.5001);
  EXPECT_NEAR(ArcLength(*curve, 0.0, 0.5).total(), chords, 1e-8);
}

TEST(FreeCurve, ProjectionGivesTheNearestPointEndsIncluded) {
  const auto arc = nurbs_arc();
  for (int i = 0; i < 100; ++i) {
    const double a = 0.3 + 0.045 * i;
    const Vec3 direction(std::cos(a), std::sin(a), 0.0);
    EXPECT_LT((arc->point(arc->project(2.3 * direction + Vec3(0, 0, 0.4), 0.5)) - 2.0 * direction).norm(),
              1e-9);
  }
  const Vec3 start(2.0 * std::cos(0.25), 2.0 * std::sin(0.25), 0.0);
  EXPECT_LT((arc->point(arc->project({2.0, 0.1, 0.0}, 0.5)) - start).norm(), 1e-12);
}

TEST(FreeCurve, ProjectionIsNotMisledByABranchWithMoreSamples) {
  // The border of a filled dome: long straight stretches beside bends that pass near them.
  const double height[] = {68.141652, 61.475738, 47.799745, 55.250753,
                           26.147358, 42.676789, 22.921387, 19.160475};
  const double depth[] = {7.106, 0.0, 60.667, -184.728, 323.178, -252.948, 100.943, -2.965};
  TColgp_Array1OfPnt poles(1, 8);
  for (int i = 1; i <= 8; ++i) poles(i) = gp_Pnt(-0.33 * depth[i - 1], depth[i - 1], height[i - 1]);
  const auto curve = make_free_curve(CurveJets(new Geom_BezierCurve(poles)), 0.0, 1.0);
  for (int i = 0; i <= 2000; ++i)
    for (const double hint : {i / 2000.0, 0.0, 0.4, 1.0}) {
      const Vec3 p = curve->point(i / 2000.0);
      EXPECT_LT((curve->point(curve->project(p, hint)) - p).norm(), 1e-9) << i << " from " << hint;
    }
}

TEST(FreeCurve, ProjectionOnAClosedCurveLooksBothWaysFromWhereItCloses) {
  // Turned so that the two ends differ by rounding, which must not say on which side the foot is.
  for (int turn = 0; turn < 20; ++turn) {
    const double start = 0.1 + 0.31 * turn;
    const gp_Ax2 axes(gp_Pnt(3, 1, 2), gp_Dir(1, 2, 3), gp_Dir(std::cos(start), std::sin(start), 0.5));
    const Handle(Geom_BSplineCurve) spline =
        GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(new Geom_Circle(axes, 2.0), 0.0, 2.0 * kPi));
    spline->SetNotPeriodic();
    const double t0 = spline->FirstParameter(), t1 = spline->LastParameter();
    const auto circle = make_free_curve(CurveJets(Handle(Geom_Curve)(spline)), t0, t1);
    for (const double share : {1e-4, 1e-3, 0.01, 0.99, 0.999, 1.0 - 1e-4}) {
      const Vec3 p = circle->point(t0 + share * (t1 - t0));
      for (const double hint : {t0, t1})
        EXPECT_LT((circle->point(circle->project(p, hint)) - p).norm(), 1e-9) << turn << " " << share;
    }
  }
}

}  // namespace
}  // namespace octet
