// SPDX-License-Identifier: BSD-3-Clause
// Faces that cross are told, with a point on both and how deep; faces that meet in edges are not.
#include "geom/face_crossings.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

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

TEST(FaceCrossings, NoneWhereFacesMeetInTheirEdges) {
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()).crossings().empty());
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape()).crossings().empty());
}

}  // namespace
}  // namespace octet::test
