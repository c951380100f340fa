// SPDX-License-Identifier: BSD-3-Clause
// Splines that are planes, quadrics and tori become these where they lie, and are fused as these.
#include "geom/occt/closed_forms.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>
#include <map>
#include <utility>

#include "geom/occt/curve_gaps.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"
#include "tests/geom/occt/solid_in.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

/// The solid in a shape, all of splines.
TopoDS_Shape as_splines_all_over(const TopoDS_Shape& shape) {
  return solid_in(BRepBuilderAPI_NurbsConvert(shape, true).Shape());
}

std::map<GeomAbs_SurfaceType, int> kinds(const TopoDS_Shape& shape) {
  std::map<GeomAbs_SurfaceType, int> count;
  const TopTools_IndexedMapOfShape faces = sub_shapes(shape, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) ++count[BRepAdaptor_Surface(TopoDS::Face(faces(i))).GetType()];
  return count;
}

/// Planes, cylinders and cones, with seams, a pole, and edges where they meet others.
std::vector<TopoDS_Shape> parts() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  BRepFilletAPI_MakeFillet rounded(block);
  for (TopExp_Explorer it(block, TopAbs_EDGE); it.More(); it.Next())
    rounded.Add(2.0, TopoDS::Edge(it.Current()));
  const TopoDS_Shape tube = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 10, -1), gp::DZ()), 3.0, 40.0).Shape();
  const TopoDS_Shape across =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-1, 10, 15), gp::DX()), 2.0, 40.0).Shape();
  return {block, rounded.Shape(), BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, tube).Shape(), across).Shape(),
          BRepPrimAPI_MakeCone(4.0, 2.0, 5.0).Shape(), BRepPrimAPI_MakeCone(4.0, 0.0, 5.0).Shape()};
}

TEST(ClosedForms, SplinesBecomeWhatTheyAreAndStayWhereTheyLie) {
  for (const TopoDS_Shape& part : parts()) {
    const TopoDS_Shape solid = solid_in(part), splines = as_splines_all_over(part);
    const double volume = refined_volume_of(solid);  // OCCT's integrals over splines are a little off
    std::map<GeomAbs_SurfaceType, int> wanted = kinds(solid);
    ASSERT_NE(wanted, kinds(splines));
    // Spheres stay: OCCT's fuse takes longer with them than with their splines.
    wanted[GeomAbs_BSplineSurface] = std::exchange(wanted[GeomAbs_Sphere], 0);
    std::erase_if(wanted, [](const auto& kind) { return kind.second == 0; });
    EXPECT_EQ(
        give_closed_forms({splines}).size(),
        static_cast<std::size_t>(sub_shapes(solid, TopAbs_FACE).Extent() - kinds(solid)[GeomAbs_Sphere]));
    EXPECT_EQ(kinds(splines), wanted);
    EXPECT_NEAR(refined_volume_of(splines), volume, 1e-6 * volume);
    EXPECT_LT(widest_curve_gap(splines), 2e-7);
    EXPECT_TRUE(BRepCheck_Analyzer(splines).IsValid());
    EXPECT_EQ(give_closed_forms({splines}).size(), 0U) << "there are none any more";
  }
}

TEST(ClosedForms, SolidsInsideOutKeepTheirSides) {
  TopoDS_Shape hole = as_splines_all_over(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
  hole.Reverse();
  EXPECT_LT(refined_volume_of(hole), 0.0);
  EXPECT_EQ(give_closed_forms({hole}).size(), 3U);
  EXPECT_NEAR(refined_volume_of(hole), -20.0 * kPi, 1e-5);
}

TEST(ClosedForms, SolidsThatStandTwiceChangeOnceForBoth) {
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
  const TopoDS_Shape pin = as_splines_all_over(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
  const TopoDS_Shape placed = pin.Moved(TopLoc_Location(move));
  EXPECT_EQ(give_closed_forms({placed, pin}).size(), 3U);
  for (const TopoDS_Shape& solid : {pin, placed}) {
    EXPECT_EQ(kinds(solid)[GeomAbs_Cylinder], 1);
    EXPECT_NEAR(refined_volume_of(solid), 20.0 * kPi, 1e-5);
    EXPECT_LT(widest_curve_gap(solid), 2e-7);
  }
}

TEST(ClosedForms, WhatIsNoClosedFormStays) {
  const TopoDS_Shape box = as_splines_all_over(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  // An edge whose tolerance does not reach the plane that the face is to rounding.
  const TopoDS_Face face = TopoDS::Face(sub_shapes(box, TopAbs_FACE)(1));
  const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
  const TopoDS_Edge edge = TopoDS::Edge(edges(1));
  double t0 = 0.0, t1 = 0.0;
  TopLoc_Location place;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, place, t0, t1);
  gp_Trsf off;
  off.SetTranslation(gp_Vec(1e-5, 1e-5, 1e-5));
  BRep_Builder().UpdateEdge(edge, Handle(Geom_Curve)::DownCast(curve->Transformed(off)), place, 1e-7);
  BRep_Builder().Range(edge, t0, t1);
  EXPECT_EQ(give_closed_forms({box}).size(), 4U) << "the two faces at the edge stay";
  EXPECT_EQ(kinds(box)[GeomAbs_BSplineSurface], 2);
}

TEST(ClosedForms, FacesGoBackToTheSplinesThatTheyWere) {
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
  for (const TopoDS_Shape& part : parts()) {
    const TopoDS_Shape splines = as_splines_all_over(part).Moved(TopLoc_Location(move));
    const auto before = kinds(splines);
    const double volume = refined_volume_of(splines), gap = widest_curve_gap(splines);
    const std::vector<ClosedForm> forms = give_closed_forms({splines});
    EXPECT_NE(kinds(splines), before);
    take_back(forms);
    EXPECT_EQ(kinds(splines), before);
    EXPECT_EQ(refined_volume_of(splines), volume);
    EXPECT_EQ(widest_curve_gap(splines), gap);
  }
}

TEST(ClosedForms, SolidsOfSplinesAreJoinedAndANoteTells) {
  const TopoDS_Shape plate =
      as_splines_all_over(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -2), gp_Pnt(5, 5, 0)).Shape());
  const TopoDS_Shape pin = as_splines_all_over(BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape());
  const Model model = model_from_shape(compound_of(std::vector<TopoDS_Shape>{plate, pin}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 6 + 3);
  EXPECT_TRUE(has_note(model, "9 face(s) whose splines are planes"));
}

}  // namespace
}  // namespace octet::test
