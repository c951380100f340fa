// SPDX-License-Identifier: BSD-3-Clause
#include "geom/occt/face_volumes.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), 4.0, 3.0, 2.0).Shape(); }

TopoDS_Shape with_hole(const TopoDS_Shape& solid) {
  const gp_Ax2 axis(gp_Pnt(1.0, 1.0, -1.0), gp_Dir(0.0, 0.0, 1.0));
  return BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakeCylinder(axis, 0.5, 4.0).Shape()).Shape();
}

TEST(FaceVolumes, ASolidHasTheSumOfItsFaces) {
  FaceVolumes volumes(gp_Pnt(2.0, 1.0, 1.0));
  const TopoDS_Shape drilled = with_hole(box());
  EXPECT_NEAR(volumes.of(drilled), volume_of(drilled), 1e-9);
  EXPECT_NEAR(volumes.of(drilled.Reversed()), -volume_of(drilled), 1e-9);
  // A sphere's one face is its whole surface.
  EXPECT_NEAR(volumes.of(BRepPrimAPI_MakeSphere(3.0).Shape()), 36.0 * std::numbers::pi, 1e-6);
}

TEST(FaceVolumes, TheChangeIsThatOfTheFacesThatDiffer) {
  const TopoDS_Shape whole = box(), drilled = with_hole(whole);
  const double hole = 0.25 * std::numbers::pi * 2.0;
  EXPECT_NEAR(FaceVolumes(gp_Pnt(2.0, 1.0, 1.0)).change(whole, drilled), -hole, 1e-9);
  EXPECT_NEAR(FaceVolumes(gp_Pnt(2.0, 1.0, 1.0)).change(drilled, whole), hole, 1e-9);
  // Wherever the cones start, for the faces that differ are closed with those that do not.
  EXPECT_NEAR(FaceVolumes(gp_Pnt(-7.0, 5.0, 9.0)).change(whole, drilled), -hole, 1e-9);
  EXPECT_EQ(FaceVolumes(gp_Pnt(2.0, 1.0, 1.0)).change(whole, whole), 0.0);
  // Faces that bound from their other side are others.
  EXPECT_NEAR(FaceVolumes(gp_Pnt(2.0, 1.0, 1.0)).change(whole, whole.Reversed()), -48.0, 1e-9);
}

TEST(FaceVolumes, FacesOfOtherPlacesAreOthers) {
  FaceVolumes volumes(gp_Pnt(2.0, 1.0, 1.0));
  const TopoDS_Shape drilled = with_hole(box());
  gp_Trsf far;
  far.SetTranslation(gp_Vec(10.0, 0.0, 0.0));
  const TopoDS_Shape moved = drilled.Moved(TopLoc_Location(far));
  EXPECT_NEAR(volumes.of(drilled), volume_of(drilled), 1e-9);
  EXPECT_NEAR(volumes.of(moved), volume_of(drilled), 1e-9);
  EXPECT_NEAR(volumes.change(drilled, moved), 0.0, 1e-9);
}

}  // namespace
}  // namespace octet
