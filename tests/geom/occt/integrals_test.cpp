// SPDX-License-Identifier: BSD-3-Clause
// Areas and volumes of curved parts against their formulas.
#include "geom/occt/integrals.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <gp.hxx>
#include <utility>
#include <vector>

#include "geom/occt/canonical.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

double area_of(const Model& model) {
  double area = 0.0;
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  return area;
}

TEST(Integrals, OfABoxRoundedByCylindersAndSpheres) {
  const Vec3 size(40.0, 30.0, 20.0);
  for (const double radius : {0.5, 4.0}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(size.x(), size.y(), size.z()).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer e(box, TopAbs_EDGE); e.More(); e.Next())
      fillet.Add(radius, TopoDS::Edge(e.Current()));
    const Model model = model_from_shape(fillet.Shape());
    ASSERT_EQ(model.count(2), 26);
    const Vec3 core = size - Vec3::Constant(2.0 * radius);
    const double sides = core.x() * core.y() + core.y() * core.z() + core.z() * core.x(),
                 square = radius * radius;
    const double area = 2.0 * sides + 2.0 * M_PI * radius * core.sum() + 4.0 * M_PI * square;
    const double volume =
        core.prod() + 2.0 * radius * sides + M_PI * square * core.sum() + 4.0 / 3.0 * M_PI * square * radius;
    EXPECT_NEAR(area_of(model), area, 1e-9 * area);
    EXPECT_NEAR(model.region(1).volume, volume, 1e-9 * volume);
  }
}

TEST(Integrals, OfARing) {
  const Model ring = model_from_shape(BRepPrimAPI_MakeTorus(10.0, 3.0).Shape());
  const double area = 4.0 * M_PI * M_PI * 30.0, volume = 2.0 * M_PI * M_PI * 90.0;
  EXPECT_NEAR(area_of(ring), area, 1e-9 * area);
  EXPECT_NEAR(ring.region(1).volume, volume, 1e-9 * volume);
}

/// A planar face under one triangle, (0, 0), (5, -10), (10, 0), and a spline from (10, 0) back to (0, 0) of
/// three parabolas, of which the triangulation has the chord alone.
TopoDS_Face under_three_parabolas(const Handle(Geom2d_BSplineCurve) & spline) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
  const gp_Pnt left(0.0, 0.0, 0.0), below(5.0, -10.0, 0.0), right(10.0, 0.0, 0.0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(left, below), BRepBuilderAPI_MakeEdge(below, right),
                               BRepBuilderAPI_MakeEdge(spline, plane));
  BRepLib::BuildCurves3d(wire.Wire());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(plane, wire.Wire());
  const Handle(Poly_Triangulation) triangulation = new Poly_Triangulation(3, 1, true);
  int node = 0;
  for (const gp_Pnt& p : {left, below, right}) {
    triangulation->SetNode(++node, p);
    triangulation->SetUVNode(node, gp_Pnt2d(p.X(), p.Y()));
  }
  triangulation->SetTriangle(1, Poly_Triangle(1, 2, 3));
  BRep_Builder builder;
  builder.UpdateFace(face, triangulation);
  TColStd_Array1OfInteger nodes(1, 2);
  nodes(1) = 3;
  nodes(2) = 1;
  TColStd_Array1OfReal parameters(1, 2);
  parameters(1) = spline->FirstParameter();
  parameters(2) = spline->LastParameter();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0.0, last = 0.0;
    if (BRep_Tool::CurveOnSurface(edge, face, first, last)->IsKind(STANDARD_TYPE(Geom2d_BSplineCurve)))
      builder.UpdateEdge(edge, new Poly_PolygonOnTriangulation(nodes, parameters), triangulation);
  }
  return face;
}

TEST(Integrals, OfAFaceWhoseSideIsASplineOfSeveralPieces) {
  TColgp_Array1OfPnt2d poles(1, 5);
  int pole = 0;
  for (const auto& [x, y] : {std::pair(10.0, 0.0), {9.5, 3.0}, {8.0, 1.0}, {1.0, 4.0}, {0.0, 0.0}})
    poles(++pole) = gp_Pnt2d(x, y);
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger times(1, 4);
  int knot = 0;
  for (const auto& [at, multiplicity] : {std::pair(0.0, 3), {0.2, 1}, {0.7, 1}, {1.0, 3}}) {
    knots(++knot) = at;
    times(knot) = multiplicity;
  }
  const Handle(Geom2d_BSplineCurve) spline = new Geom2d_BSplineCurve(poles, knots, times, 2);
  const TopoDS_Face face = under_three_parabolas(spline);

  double above = 0.0;  // by Simpson's rule, exact for parabolas' areas
  for (int k = 1; k < 4; ++k) {
    const double step = knots(k + 1) - knots(k);
    for (const auto& [share, weight] : {std::pair(0.0, 1.0 / 6), {0.5, 4.0 / 6}, {1.0, 1.0 / 6}}) {
      gp_Pnt2d p;
      gp_Vec2d d;
      spline->D1(knots(k) + share * step, p, d);
      above += 0.5 * weight * step * (p.X() * d.Y() - p.Y() * d.X());
    }
  }
  EXPECT_NEAR(integrate_face(face, *make_surface(face, 1)).area, 50.0 + above, 1e-9);
}

/// Between x = 0 and 800 the plane y = 0 below z = 160 (s - s^3), s = x / 800, as IGES files have the ends of
/// wings: 48 pieces of unlike widths side by side, as long as one another in the parameter.
TopoDS_Face wing_end() {
  constexpr int kPieces = 48;
  const auto section = [](double s) { return gp_Pnt(800.0 * s, 0.0, 160.0 * (s - s * s * s)); };
  const auto way = [](double s) { return gp_Vec(800.0, 0.0, 160.0 * (1.0 - 3.0 * s * s)); };
  std::vector<double> ends{0.0};
  for (int i = 0; i < kPieces; ++i) ends.push_back(ends.back() + (i % 3 == 0 ? 1.0 : i % 7 == 0 ? 9.0 : 3.0));
  for (double& end : ends) end /= ends.back();
  TColgp_Array2OfPnt poles(1, 3 * kPieces + 1, 1, 2);
  TColStd_Array1OfReal along(1, kPieces + 1), across(1, 2);
  TColStd_Array1OfInteger times(1, kPieces + 1), twice(1, 2);
  across(1) = 0.0;
  across(2) = 1.0;
  twice.Init(2);
  times.Init(3);
  times(1) = times(kPieces + 1) = 4;
  for (int i = 0; i <= kPieces; ++i) {
    const double s = ends[static_cast<std::size_t>(i)];
    along(i + 1) = i;
    poles(3 * i + 1, 1) = section(s);
    if (i == kPieces) break;
    const double next = ends[static_cast<std::size_t>(i) + 1], third = (next - s) / 3.0;
    poles(3 * i + 2, 1) = section(s).Translated(third * way(s));
    poles(3 * i + 3, 1) = section(next).Translated(-third * way(next));
  }
  for (int i = 1; i <= 3 * kPieces + 1; ++i) poles(i, 2) = gp_Pnt(poles(i, 1).X(), 0.0, 0.0);
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, along, across, times, twice, 3, 1);
  return BRepBuilderAPI_MakeFace(surface, 1e-6);
}

TEST(Integrals, OfAPlaneThatIsASplineOfManyPieces) {
  constexpr double kArea = 800.0 * 160.0 * (0.5 - 0.25), kHeight = 30.0;
  const Model wing = model_from_shape(BRepPrimAPI_MakePrism(wing_end(), gp_Vec(0.0, kHeight, 0.0)).Shape());
  int ends = 0;
  for (int f = 1; f <= wing.count(2); ++f) {
    if (!wing.is_plane(f) || wing.face(f).area < 25'000.0) continue;
    ++ends;
    EXPECT_NEAR(wing.face(f).area, kArea, 1e-9 * kArea);
  }
  EXPECT_EQ(ends, 2);
  EXPECT_NEAR(wing.region(1).volume, kHeight * kArea, 1e-9 * kHeight * kArea);
}

}  // namespace
}  // namespace octet
