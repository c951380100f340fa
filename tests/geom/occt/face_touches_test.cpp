// SPDX-License-Identifier: BSD-3-Clause
// Faces that come together without an edge there are found from a place beside the contact.
#include "geom/face_touches.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>

#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"

namespace octet {
namespace {

Model side_by_side(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ReadOptions apart;
  apart.fuse = false;
  return model_from_shape(compound_of({a, b}), apart);
}

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(4, 4, 4)).Shape(); }

/// The face nearest to a place.
int face_at(const Model& model, const Vec3& p) { return model.closest(p, 1.0)->face; }

/// A cylinder of radius 1 upright beside the block's side x = 4, and the place from which it is looked for.
std::optional<FaceTouch> beside_a_cylinder(double gap) {
  const gp_Ax2 axes(gp_Pnt(5.0 + gap, 2.0, 0.5), gp::DZ());
  const Model model = side_by_side(block(), BRepPrimAPI_MakeCylinder(axes, 1.0, 3.0).Shape());
  const Vec3 place(4.0, 2.07, 1.7);
  const int side = face_at(model, place - Vec3(0.001, 0, 0)),
            round = face_at(model, Vec3(6.0 + gap, 2.0, 1.7));
  return face_touch(model, {side, round}, place, 0.2, 1e-7);
}

TEST(FaceTouches, ACylinderThatTouchesAPlaneAlongALine) {
  const auto touch = beside_a_cylinder(0.0);
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->place.x(), 4.0, 1e-9);
  EXPECT_NEAR(touch->place.y(), 2.0, 1e-3);
  EXPECT_LT(touch->distance, 1e-7);
}

TEST(FaceTouches, ACylinderInItsPlane) { EXPECT_TRUE(beside_a_cylinder(-0.001)); }

TEST(FaceTouches, ACylinderBesideAPlaneDoesNotTouchIt) { EXPECT_FALSE(beside_a_cylinder(1e-6)); }

TEST(FaceTouches, ABallThatTouchesAPlaneAtAPoint) {
  const Model model = side_by_side(block(), BRepPrimAPI_MakeSphere(gp_Pnt(2, 2, 5), 1.0).Shape());
  const Vec3 place(2.05, 2.08, 4.0);
  const std::vector<PlaceOnFace> places{{face_at(model, place - Vec3(0, 0, 0.001)), place},
                                        {face_at(model, Vec3(2, 2, 6)), Vec3(2.0, 2.05, 4.00125)}};
  const std::vector<FaceTouch> found = face_touches(model, places, 0.3, 1e-7);
  ASSERT_EQ(found.size(), 1u) << "the pair once";
  EXPECT_LT((found[0].place - Vec3(2, 2, 4)).norm(), 1e-3);
}

TEST(FaceTouches, FacesThatShareAVertexAreLeftOut) {
  const Model model = model_from_shape(block());
  std::vector<PlaceOnFace> places;
  for (const Vec3& p :
       {Vec3(2, 2, 0), Vec3(2, 0, 2), Vec3(0, 2, 2), Vec3(2, 2, 4), Vec3(2, 4, 2), Vec3(4, 2, 2)})
    places.push_back({face_at(model, p), p});
  EXPECT_TRUE(face_touches(model, places, 100.0, 1e-6).empty());
}

}  // namespace
}  // namespace octet
