// SPDX-License-Identifier: BSD-3-Clause
// The boundary is triangulated without holes where loops nearly touch, run into faces, or are shared.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <string_view>

#include "base/constants.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

TopoDS_Shape drilled(double x, double radius) {
  const gp_Ax2 axis(gp_Pnt(x, 5.0, -1.0), gp_Dir(0.0, 0.0, 1.0));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10.0, 10.0, 1.0).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, radius, 3.0).Shape())
      .Shape();
}

TEST(Triangulate, AHoleThatNearlyTouchesTheBorderStaysOpenAndTheBorderClosed) {
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    ReadOptions coarse;
    coarse.facet_deflection = 0.2;
    const Model model = model_from_shape(drilled(3.0 + gap, 3.0), coarse);
    EXPECT_EQ(check_model(model), "") << gap;
    EXPECT_NEAR(model.region(1).volume, 100.0 - 9.0 * kPi, 1e-4) << gap;
  }
}

TEST(Triangulate, ASolidAThousandthOfTheAssemblyKeepsItsHole) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, drilled(5.0, 3.0));
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(2e4, 0, 0), 1e5, 1e5, 1e5).Shape());
  const Model model = model_from_shape(both);
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.region_at(Vec3(5.0, 5.0, 0.5)), 0) << "in the hole";
  EXPECT_EQ(model.region_at(Vec3(5.0, 2.4, 0.5)), 0);
  EXPECT_EQ(model.region_at(Vec3(5.0, 1.6, 0.5)), 1);
  EXPECT_NEAR(model.region(1).volume, 100.0 - 9.0 * kPi, 1e-4);
}

TEST(Triangulate, ARoundBarOfTheDeflectionsSizeIsRoundAndTakesFewFacets) {
  // 1200 mm: a deflection of 0.6 mm, and a bore of 3 mm all its length.
  constexpr double kRadius = 1.5;
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(1200.0, 10.0, 10.0).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 5, 5), gp::DX()), kRadius, 1200.0).Shape())
          .Shape();
  const Model model = model_from_shape(bored);
  for (int f = 1; f <= model.count(2); ++f) {
    if (std::string_view(model.surface(f).kind()) != "cylinder") continue;
    EXPECT_LT(model.facets().deviation[static_cast<std::size_t>(f)], 0.02 * kRadius);
    EXPECT_LT(std::count(model.facets().face.begin(), model.facets().face.end(), f), 200);
  }
}

TEST(Triangulate, FacetsEndWhereTheFaceDoesThoughItsSidesAreBentInParameters) {
  const Model model = read_part(sample_path("bugs/skewed_roof"));
  EXPECT_EQ(check_model(model), "");
  std::vector<double> area(static_cast<std::size_t>(model.count(2)) + 1, 0.0);
  const Facets& facets = model.facets();
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto& [a, b, c] = facets.triangles[i];
    area[facets.face[i]] += triangle_area(facets.nodes[a], facets.nodes[b], facets.nodes[c]);
    for (const Vec2& uv : facets.uv[i]) EXPECT_NE(model.face_side(facets.face[i], uv), TrimSide::kOut);
  }
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_NEAR(area[f], model.face(f).area, 0.01 * model.face(f).area) << f;
}

TEST(Triangulate, FacetsStayWithinTheDeflectionAsked) {
  for (const char* name : {"bracket", "blade", "torus", "cone", "ball"}) {
    ReadOptions options;
    options.facet_deflection = sample(name).diagonal() / 500.0;
    const Model model = read_part(sample_path(name), options);
    // Deviations are inflated by half, and measured at more places than facets were refined at.
    for (int f = 1; f <= model.count(2); ++f)
      EXPECT_LT(model.facets().deviation[f], 2.0 * options.facet_deflection) << name << " Face " << f;
    for (int e = 1; e <= model.count(1); ++e)
      EXPECT_LT(model.facets().edge_deviation[e], 2.0 * options.facet_deflection) << name << " Edge " << e;
  }
}

TEST(Triangulate, NoDeflectionIsSoLargeThatASolidLosesItsFacets) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeSphere(1.0).Shape(), BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()})
    for (const double asked : {3.0, 1e300}) {
      ReadOptions options;
      options.facet_deflection = asked;
      const Model model = model_from_shape(shape, options);
      EXPECT_EQ(check_model(model), "") << asked;
      EXPECT_GT(model.facets().triangles.size(), 50u) << asked;
    }
}

TEST(Triangulate, AnEdgeInsideAFaceIsASlitOfTheFacets) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4.0, 4.0, 4.0).Shape();
  TopoDS_Shape slit =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(1.0, 1.0, 4.0), gp_Pnt(3.0, 2.0, 4.0)).Edge())
          .Wire();
  for (TopExp_Explorer it(slit, TopAbs_EDGE); it.More(); it.Next()) slit = it.Current();
  TopoDS_Wire wire;
  const BRep_Builder builder;
  builder.MakeWire(wire);
  builder.Add(wire, slit.Oriented(TopAbs_INTERNAL));
  BRepPrimAPI_MakeBox maker(4.0, 4.0, 4.0);
  TopoDS_Face top = maker.TopFace();
  top.Free(true);
  builder.Add(top, wire);
  const Model model = model_from_shape(maker.Shape());
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.count(1), 13);
  EXPECT_NEAR(model.region(1).volume, 64.0, 1e-9);
}

TEST(Triangulate, InstancesOfOnePartAreTriangulatedAlike) {
  const TopoDS_Shape part = drilled(5.0, 2.0);
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  gp_Trsf place;
  place.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(1.0, 2.0, 3.0)), 1.0);
  place.SetTranslationPart(gp_Vec(30.0, 0.0, 0.0));
  builder.Add(both, part);
  builder.Add(both, part.Moved(place));
  const Model model = model_from_shape(both);
  EXPECT_EQ(check_model(model), "");
  ASSERT_EQ(model.count(3), 2);
  EXPECT_NEAR(model.region(1).volume, model.region(2).volume, 1e-9);
  std::array<int, 2> facets{};
  for (const int face : model.facets().face) ++facets[model.face(face).region[0] == 1 ? 0 : 1];
  EXPECT_EQ(facets[0], facets[1]);
}

TEST(Triangulate, PolesSeamsAndApicesCloseAtAnyOrientation) {
  for (const TopoDS_Shape& part :
       {BRepPrimAPI_MakeSphere(1.0).Shape(), BRepPrimAPI_MakeSphere(1.0, 0.3).Shape(),
        BRepPrimAPI_MakeSphere(2.0, -0.5, 0.7).Shape(), BRepPrimAPI_MakeCone(1.0, 0.0, 3.0).Shape(),
        BRepPrimAPI_MakeCone(0.0, 2.0, 1.0, 2.5).Shape()})
    EXPECT_EQ(check_model(model_from_shape(part)), "");
}

}  // namespace
}  // namespace octet::test
