// SPDX-License-Identifier: BSD-3-Clause
// Faces as splines lie where they were, between the edges that they had.
#include "geom/occt/spline_faces.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>
#include <map>

#include "geom/occt/curve_gaps.h"
#include "geom/occt/gathered.h"
#include "geom/occt/group_fuse.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"
#include "tests/geom/occt/solid_in.h"

namespace octet::test {
namespace {

int count_splines(const TopoDS_Shape& shape) {
  int count = 0;
  const TopTools_IndexedMapOfShape faces = sub_shapes(shape, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i)
    count += BRepAdaptor_Surface(TopoDS::Face(faces(i))).GetType() == GeomAbs_BSplineSurface ? 1 : 0;
  return count;
}

TEST(SplineFaces, FacesAboutTheLastSolidAreSplinesAndEdgesStay) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(5, 5, 0)).Shape();
  const TopoDS_Shape pin = solid_in(BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape());
  const auto splines = with_spline_faces_about_last({block, pin});
  ASSERT_TRUE(splines);
  EXPECT_EQ(count_splines(splines->solids[0]), 1) << "the block's top";
  EXPECT_EQ(count_splines(splines->solids[1]), 2) << "the pin's wall and foot";
  EXPECT_EQ(splines->faces, 3);
  const std::vector<TopoDS_Shape> before{block, pin};
  for (std::size_t i = 0; i < 2; ++i) {
    const TopTools_IndexedMapOfShape was = sub_shapes(before[i], TopAbs_EDGE),
                                     is = sub_shapes(splines->solids[i], TopAbs_EDGE);
    ASSERT_EQ(was.Extent(), is.Extent());
    for (int k = 1; k <= was.Extent(); ++k) EXPECT_TRUE(is.Contains(was(k)));
  }
  EXPECT_NEAR(refined_volume_of(splines->solids[0]), 500.0, 1e-4);
  EXPECT_NEAR(refined_volume_of(splines->solids[1]), 3.0 * kPi, 1e-4);
  EXPECT_LT(widest_curve_gap(splines->solids[1]), 1e-6);
}

TEST(SplineFaces, ASolidThatIsPlacedStaysWhereItIs) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(3, 2, 0));
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(5, 5, 0)).Shape();
  const TopoDS_Shape pin =
      solid_in(BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape()).Located(TopLoc_Location(move));
  const auto splines = with_spline_faces_about_last({block, pin});
  ASSERT_TRUE(splines);
  EXPECT_EQ(count_splines(splines->solids[1]), 2);
  EXPECT_NEAR(refined_volume_of(splines->solids[1]), 3.0 * kPi, 1e-4);
  EXPECT_NEAR(vertex_box_of(splines->solids[1]).CornerMin().X(), 4.0, 1e-6);
  EXPECT_LT(widest_curve_gap(splines->solids[1]), 1e-6);
  const GroupFuse fuse(splines->solids, {}, 0.0, 1e-6, kTearOfSplines);
  ASSERT_TRUE(fuse.sound());
  EXPECT_EQ(sub_shapes(compound_of(std::vector<TopoDS_Shape>{fuse.images()[0][0], fuse.images()[1][0]}),
                       TopAbs_FACE)
                .Extent(),
            6 + 3)
      << "the pin's foot is a face of both";
}

TEST(SplineFaces, SeamsAndPolesHaveTheirCurves) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(5, 5, 0)).Shape();
  const TopoDS_Shape ball = solid_in(BRepPrimAPI_MakeSphere(2.0).Shape());
  const auto of_ball = with_spline_faces_about_last({block, ball});
  ASSERT_TRUE(of_ball);
  EXPECT_NEAR(refined_volume_of(of_ball->solids[1]), 32.0 / 3.0 * kPi, 1e-3);
  EXPECT_LT(widest_curve_gap(of_ball->solids[1]), 1e-6);
  const auto of_ring =
      with_spline_faces_about_last({block, solid_in(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape())});
  ASSERT_TRUE(of_ring);
  EXPECT_NEAR(refined_volume_of(of_ring->solids[1]), 6.0 * kPi * kPi, 1e-3);
  EXPECT_LT(widest_curve_gap(of_ring->solids[1]), 1e-6);
}

/// Half of a cylinder that ends at its seam: the edge there has a curve on either side of the cylinder, and
/// one of them lies beyond the face.
TEST(SplineFaces, OfASeamThatIsAnEndOneSideIsTaken) {
  const TopoDS_Shape whole = BRepPrimAPI_MakeCylinder(4.0, 2.0).Shape();
  const TopoDS_Shape half = solid_in(
      BRepAlgoAPI_Common(whole, BRepPrimAPI_MakeBox(gp_Pnt(-5, 0, -5), gp_Pnt(5, 5, 5)).Shape()).Shape());
  int ends = 0;
  const TopTools_IndexedMapOfShape faces = sub_shapes(half, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i));
    std::map<bool, int> uses;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      ++uses[BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), face)];
    ends += uses[true];
  }
  ASSERT_EQ(ends, 1) << "else this test needs others";
  const auto splines =
      with_spline_faces_about_last({BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, -9), gp_Pnt(3, 9, 9)).Shape(), half});
  ASSERT_TRUE(splines);
  EXPECT_EQ(count_splines(splines->solids[1]), 4);
  EXPECT_LT(widest_curve_gap(splines->solids[1]), 1e-6);
  EXPECT_NEAR(refined_volume_of(splines->solids[1]), 16.0 * kPi, 1e-3);
}

TEST(SplineFaces, WhatSolidsShareTheyShareStill) {
  const GroupFuse halves({BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), gp_Pnt(0, 1, 1)).Shape(),
                          BRepPrimAPI_MakeBox(gp_Pnt(0, -1, -1), gp_Pnt(1, 1, 1)).Shape()},
                         {}, 0.0, 1e-6);
  ASSERT_TRUE(halves.sound());
  std::vector<TopoDS_Shape> solids{halves.images()[0].front(), halves.images()[1].front()};
  solids.push_back(solid_in(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -2), gp::DZ()), 0.5, 4.0).Shape()));
  const auto splines = with_spline_faces_about_last(solids);
  ASSERT_TRUE(splines);
  EXPECT_EQ(sub_shapes(compound_of(splines->solids), TopAbs_FACE).Extent(), 11 + 3);
  const GroupFuse fuse(splines->solids, {}, 0.0, 1e-6, kTearOfSplines);
  ASSERT_TRUE(fuse.sound());
  ASSERT_EQ(fuse.images()[2].size(), 4u) << "the two ends and the two halves within";
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(fuse.keeps_volume(i, solids[i])) << i;
}

TEST(SplineFaces, TakenBackNothingIsLeft) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -5), gp_Pnt(5, 5, 0)).Shape();
  const auto splines = with_spline_faces_about_last({block, solid_in(BRepPrimAPI_MakeSphere(2.0).Shape())});
  ASSERT_TRUE(splines);
  ASSERT_FALSE(splines->curves.empty());
  ASSERT_FALSE(splines->tolerances.empty());
  take_back(*splines);
  for (const auto& [shape, tolerance] : splines->tolerances)
    EXPECT_LE(BRep_Tool::MaxTolerance(shape, shape.ShapeType()), tolerance);
  for (const auto& [edge, face] : splines->curves) {
    double first = 0.0, last = 0.0;
    EXPECT_TRUE(BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull());
  }
}

}  // namespace
}  // namespace octet::test
