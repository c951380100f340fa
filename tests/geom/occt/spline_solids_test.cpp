// SPDX-License-Identifier: BSD-3-Clause
// Solids as splines are the same solids; what OCCT cannot join as it is can be joined so.
#include "geom/occt/spline_solids.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Trsf.hxx>

#include "geom/model_check.h"
#include "geom/occt/converted_curves.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/fuse.h"
#include "geom/occt/fuse_attempts.h"
#include "geom/occt/gathered.h"
#include "geom/occt/sub_shapes.h"
#include "tests/geom/occt/solid_in.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

double precise_volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-7);
  return properties.Mass();
}

/// Along z, turned about y, then moved.
TopoDS_Shape cone(double low, double high, double height, double angle, const gp_Vec& to) {
  gp_Trsf turn, move;
  turn.SetRotation(gp::OY(), angle);
  move.SetTranslation(to);
  const TopoDS_Shape shape = BRepPrimAPI_MakeCone(low, high, height).Shape();
  return solid_in(BRepBuilderAPI_Transform(shape, move * turn, true).Shape());
}

/// Two cones that the general fuse does not join with any tolerance (OCCT 7.6).
std::vector<TopoDS_Shape> cones_at_odds() {
  return {cone(1.75, 2.0, 3.25, kPi / 2, gp_Vec(-0.75, -0.25, 0.25)),
          cone(1.0, 0.75, 1.25, kPi, gp_Vec(-0.5, 0.25, -0.25))};
}

double volume_of_cone(double low, double high, double height) {
  return kPi * height / 3.0 * (low * low + low * high + high * high);
}

double sum_of(const std::vector<TopoDS_Shape>& solids) {
  double sum = 0.0;
  for (const TopoDS_Shape& solid : solids) sum += precise_volume(solid);
  return sum;
}

bool all_splines(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() != GeomAbs_BSplineSurface) return false;
  return true;
}

TopoDS_Edge circle_of(const TopoDS_Shape& band) {
  for (TopExp_Explorer it(band, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), TopoDS::Face(band)))
      return TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
  return {};
}

/// As OCCT 7.6 leaves it now and then: an edge whose curve on a band begins on the other side of the seam,
/// within one of many spans, and which has the size of the band for a tolerance.
TEST(SplineSolids, CurvesThatBeginBeyondASeamAreFittedFromTheOldOnes) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(4.0, 0.8).Shape();
  const TopoDS_Face band = TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current());
  const TopoDS_Edge circle = circle_of(band);
  BRepBuilderAPI_NurbsConvert convert(band, true);
  const TopoDS_Face made = TopoDS::Face(convert.Shape());
  const TopoDS_Edge edge = TopoDS::Edge(convert.ModifiedShape(circle).Oriented(TopAbs_FORWARD));
  double first = 0.0, last = 0.0;
  const auto curve =
      Handle(Geom2d_BSplineCurve)::DownCast(BRep_Tool::CurveOnSurface(edge, made, first, last)->Copy());
  ASSERT_FALSE(curve.IsNull());
  while (curve->NbKnots() < 100)
    for (int k = curve->NbKnots(); k > 1; --k)
      curve->InsertKnot(0.5 * (curve->Knot(k - 1) + curve->Knot(k)), 1, 1e-15);
  const gp_Pnt2d begin = curve->Pole(1), end = curve->Pole(curve->NbPoles());
  curve->SetPole(1, gp_Pnt2d(end.X(), begin.Y()));
  const BRep_Builder builder;
  builder.UpdateEdge(edge, curve, made, 8.0);
  EXPECT_LT(curve_gap(edge, made), 1e-3) << "between its samples";
  EXPECT_FALSE(lower_tolerances_to(made, 1e-4));
  EXPECT_EQ(BRep_Tool::Tolerance(edge), 8.0);
  mend_conversion(band, convert, 1e-6);
  EXPECT_TRUE(lower_tolerances_to(made, 1e-4));
  EXPECT_LT(BRep_Tool::MaxTolerance(made, TopAbs_EDGE), 2e-6);
  EXPECT_LT(BRep_Tool::MaxTolerance(made, TopAbs_VERTEX), 2e-6);
  const auto fitted = BRep_Tool::CurveOnSurface(edge, made, first, last);
  EXPECT_NEAR(fitted->Value(first).X(), begin.X(), 1e-6);
}

TEST(SplineSolids, TheSolidStaysWhatItWas) {
  const std::vector<TopoDS_Shape> solids = cones_at_odds();
  const auto splines = as_splines(solids, {0});
  ASSERT_TRUE(splines);
  EXPECT_TRUE(all_splines(splines->solids[0]));
  EXPECT_TRUE(splines->solids[1].IsSame(solids[1])) << "not asked for";
  EXPECT_NEAR(precise_volume(splines->solids[0]), volume_of_cone(1.75, 2.0, 3.25), 2e-4);
  const TopoDS_Shape face = TopExp_Explorer(solids[0], TopAbs_FACE).Current();
  ASSERT_EQ(splines->history->Modified(face).Extent(), 1);
  EXPECT_TRUE(sub_shapes(splines->solids[0], TopAbs_FACE).Contains(splines->history->Modified(face).First()));
}

TEST(SplineSolids, WhatTheyShareTheyShareAfterwards) {
  const TopoDS_Shape low = BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape();
  TopoDS_Shape disk;
  for (TopExp_Explorer it(low, TopAbs_FACE); it.More(); it.Next()) disk = it.Current();
  std::vector<TopoDS_Shape> cap{disk};
  const TopoDS_Shape other = solid_of(cap);
  const auto both = as_splines({solid_in(low), other}, {0, 1});
  ASSERT_TRUE(both);
  EXPECT_EQ(sub_shapes(compound_of(both->solids), TopAbs_FACE).Extent(), 3) << "the disk is one face of both";
  const auto one = as_splines({solid_in(low), other}, {0});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->history->Modified(disk).Extent(), 2) << "its spline, and itself, for the other still has it";
}

TEST(SplineSolids, OffsetSurfacesStay) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  EXPECT_TRUE(as_splines({solid_of(faces)}, {0}));
  const BRep_Builder builder;
  const TopoDS_Face last = TopoDS::Face(faces.back());
  builder.UpdateFace(last, new Geom_OffsetSurface(BRep_Tool::Surface(last), 0.0), TopLoc_Location(), 1e-7);
  EXPECT_FALSE(as_splines({solid_of(faces)}, {0}));
}

TEST(SplineSolids, WhatNoToleranceJoinsIsJoinedAsSplines) {
  const std::vector<TopoDS_Shape> solids = cones_at_odds();
  EXPECT_FALSE(GroupFuse(solids, {}, 0.0, 1e-6).sound()) << "else this test needs others";
  const auto fuse = best_fuse(solids, 0.0);
  ASSERT_TRUE(fuse->sound());
  EXPECT_FALSE(fuse->as_splines().empty());
  EXPECT_NEAR(sum_of(fuse->images()[0]), volume_of_cone(1.75, 2.0, 3.25), 1e-4);
  EXPECT_NEAR(sum_of(fuse->images()[1]), volume_of_cone(1.0, 0.75, 1.25), 1e-4);
  const Model model = model_from_shape(compound_of(solids));
  EXPECT_TRUE(has_note(model, "1 of 2 solids that touch were turned into splines"));
  EXPECT_TRUE(model.parts().faults.empty());
  EXPECT_EQ(check_model(model), "");
}

TEST(SplineSolids, AGroupIsJoinedWithThoseThatNeedItAsSplines) {
  std::vector<TopoDS_Shape> solids = cones_at_odds();
  solids.push_back(BRepPrimAPI_MakeBox(gp_Pnt(0, -3, 2.2), gp_Pnt(4, 3, 4)).Shape());  // on the first cone
  const auto fuse = best_fuse(solids, 0.0);
  ASSERT_TRUE(fuse->sound());
  EXPECT_FALSE(fuse->as_splines().empty());
  EXPECT_NEAR(sum_of(fuse->images()[0]), volume_of_cone(1.75, 2.0, 3.25), 1e-4);
  EXPECT_NEAR(sum_of(fuse->images()[1]), volume_of_cone(1.0, 0.75, 1.25), 1e-4);
  EXPECT_NEAR(sum_of(fuse->images()[2]), 4.0 * 6.0 * 1.8, 1e-4);
}

/// Two such pairs of cones, each with boxes on it: all that splines join stand apart at once, for a large
/// group is not fused with them, and each is joined late.
TEST(SplineSolids, OfAManyAllThatNeedItStandApartAtOnce) {
  std::vector<TopoDS_Shape> solids;
  const gp_Vec apart(4.0, 0.0, 0.0);
  for (const TopoDS_Shape& cone : cones_at_odds()) {
    gp_Trsf beside;
    beside.SetTranslation(apart);
    solids.push_back(cone);
    solids.push_back(BRepBuilderAPI_Transform(cone, beside, true).Shape());
  }
  for (int i = 0; i < 5; ++i)  // a row that stands on the first cone of both
    solids.push_back(BRepPrimAPI_MakeBox(gp_Pnt(i - 1, -3, 2.2), gp_Pnt(i, 3, 4)).Shape());
  const auto fuse = best_fuse(solids, 0.0);
  ASSERT_EQ(fuse->conflicts().size(), 2u);
  for (const FuseConflict& conflict : fuse->conflicts()) {
    EXPECT_TRUE(conflict.splines_join);
    EXPECT_EQ(conflict.solids[0] + 2, conflict.solids[1]);
  }
  SolidSet set{solids, new BRepTools_History(), {}};
  std::vector<KeptApart> kept;
  std::vector<DoneFuse> done;
  fuse_touching(set, 0.0, kept, done);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(done.size(), 4u) << "the group, what is left of it, and the two that come late";
  for (const KeptApart& one : kept) {
    EXPECT_TRUE(one.splines_join);
    EXPECT_TRUE(one.late);
  }
  for (const TopoDS_Shape& solid : solids) {
    double volume = 0.0;
    for (const TopoDS_Shape& image : set.history->Modified(solid)) volume += precise_volume(image);
    EXPECT_NEAR(volume, precise_volume(solid), 1e-3);
  }
}

}  // namespace
}  // namespace octet::test
