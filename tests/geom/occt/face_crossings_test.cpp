// SPDX-License-Identifier: BSD-3-Clause
// Faces that cross are told, with a point on both and how deep; faces that meet in edges are not.
#include "geom/face_crossings.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include <cmath>
#include <utility>
#include <vector>

#include "geom/occt/from_shape.h"
#include "geom/occt/reader.h"
#include "tests/support/crossed.h"
#include "tests/support/with_void.h"

namespace octet::test {
namespace {

/// One solid whose two shells cross: a box of side 10, and a rod through its top, which is a void to the
/// file.
TopoDS_Shape box_with_a_void_through_its_top() {
  return with_void(
      box_between({0, 0, 0}, {10, 10, 10}),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5.0, 5.0, 4.0), gp_Dir(0.0, 0.0, 1.0)), 2.0, 9.0).Shape());
}

TEST(FaceCrossings, AShellThatGoesThroughAnotherCrossesIt) {
  ReadJob job;
  job.shape = box_with_a_void_through_its_top();
  const Model model(read_job(job));  // the first reading only: the second mends it
  const std::vector<FaceCrossing> crossings = model.crossings();
  ASSERT_EQ(crossings.size(), 1u);
  const FaceCrossing& crossing = crossings.front();
  EXPECT_NEAR(crossing.place.z(), 10.0, 1e-9);
  EXPECT_NEAR(std::hypot(crossing.place.x() - 5.0, crossing.place.y() - 5.0), 2.0, 1e-9);
  EXPECT_GT(crossing.depth, 2.5);  // 3 in truth, both to the box's sides and to the rod's end
  EXPECT_LE(crossing.depth, 3.0 + 1e-9);
  EXPECT_LT(crossing.face[0], crossing.face[1]);
}

TEST(FaceCrossings, FacesOfFewFacetsThatPierceEachOtherAtTheirEdges) {
  ReadJob job;
  job.shape = crossed_boxes();
  const std::vector<FaceCrossing> crossings = Model(read_job(job)).crossings();
  EXPECT_EQ(crossings.size(), 6u) << "three sides of either box with two of the other each";
  for (const FaceCrossing& crossing : crossings) EXPECT_NEAR(crossing.depth, 2.5, 1e-9);
}

/// A round bar along a parabola that turns by a right angle, with a radius of 14.1 at least.
TopoDS_Shape bent_bar(double radius) {
  TColgp_Array1OfPnt poles(1, 3);
  poles.SetValue(1, gp_Pnt(0.0, 0.0, 0.0));
  poles.SetValue(2, gp_Pnt(0.0, 0.0, 20.0));
  poles.SetValue(3, gp_Pnt(20.0, 0.0, 20.0));
  return bar_along(new Geom_BezierCurve(poles), radius);
}

TEST(FaceCrossings, APipeBentTighterThanItIsThickCrossesItself) {
  ReadJob job;
  job.shape = bent_bar(17.0);
  const Model model(read_job(job));
  const std::vector<FaceCrossing> crossings = model.crossings();
  ASSERT_EQ(crossings.size(), 1u);
  const FaceCrossing& crossing = crossings.front();
  EXPECT_TRUE(crossing.is_of_itself());
  EXPECT_LT((model.face_project(crossing.face[0], crossing.place).point - crossing.place).norm(), 1e-6);
  EXPECT_GT(crossing.place.x(), 0.0) << "on the inside of the bend";
  EXPECT_LT(crossing.place.z(), 20.0);
  EXPECT_GT(crossing.depth, 0.1);
  EXPECT_LT(crossing.depth, 17.0);
}

TEST(FaceCrossings, AFoldOfWhichMostFacetsThatPierceOthersAreAtItsRims) {
  for (const auto& [radius, depth] : {std::pair(2.5, 0.4), std::pair(5.0, 3.0)}) {
    ReadJob job;
    job.shape = folded_bar(radius);
    const std::vector<FaceCrossing> crossings = Model(read_job(job)).crossings();
    ASSERT_EQ(crossings.size(), 1u) << radius;
    EXPECT_TRUE(crossings.front().is_of_itself()) << radius;
    EXPECT_GT(crossings.front().depth, depth) << radius;
  }
}

TEST(FaceCrossings, OneWithRoomInItsBendDoesNot) {
  EXPECT_TRUE(model_from_shape(bent_bar(10.0)).crossings().empty());
}

TEST(FaceCrossings, NoneWhereFacesMeetInTheirEdges) {
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()).crossings().empty());
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape()).crossings().empty());
}

}  // namespace
}  // namespace octet::test
