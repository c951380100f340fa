// SPDX-License-Identifier: BSD-3-Clause
// Loose faces of bodies that touch: which belong together.
#include "geom/occt/loose_bodies.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <numbers>

#include "geom/occt/sew.h"
#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

void add_loose_faces(const TopoDS_Shape& solid, std::vector<TopoDS_Shape>& faces) {
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
}

/// A plate between two blocks of the same width: four faces at each of eight edges.
std::vector<TopoDS_Shape> faces_of_a_sandwich() {
  std::vector<TopoDS_Shape> faces;
  add_loose_faces(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 10, 10, 3).Solid(), faces);
  add_loose_faces(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 3), 10, 10, 0.1).Solid(), faces);
  add_loose_faces(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 3.1), 10, 10, 2).Solid(), faces);
  return faces;
}

TEST(LooseBodies, FacesThatCloseOneAfterTheOther) {
  const auto bodies = bodies_in_order(faces_of_a_sandwich(), 1e-6);
  ASSERT_EQ(bodies.size(), 3u);
  for (const auto& body : bodies) EXPECT_EQ(body.size(), 6u);
}

TEST(LooseBodies, NoneWhereFacesOfTwoAreMixedOrOneIsMissing) {
  std::vector<TopoDS_Shape> faces = faces_of_a_sandwich();
  std::swap(faces[2], faces[8]);
  EXPECT_LT(bodies_in_order(faces, 1e-6).size(), 3u);
  faces = faces_of_a_sandwich();
  faces.erase(faces.begin() + 7);
  EXPECT_TRUE(bodies_in_order(faces, 1e-6).empty());
  faces.resize(6);
  EXPECT_TRUE(bodies_in_order(faces, 1e-6).empty()) << "one body";
}

TEST(LooseBodies, SewingKeepsThemApart) {
  const Sewn sewn = sew_faces(faces_of_a_sandwich(), {});
  ASSERT_EQ(sewn.solids.size(), 3u);
  std::vector<double> volumes;
  for (const TopoDS_Shape& solid : sewn.solids) volumes.push_back(volume_of(solid));
  std::sort(volumes.begin(), volumes.end());
  EXPECT_NEAR(volumes[0], 10.0, 1e-9);
  EXPECT_NEAR(volumes[1], 200.0, 1e-9);
  EXPECT_NEAR(volumes[2], 300.0, 1e-9);
}

TEST(LooseBodies, SeamsOfTwoPinsMayMeet) {
  std::vector<TopoDS_Shape> faces;
  add_loose_faces(BRepPrimAPI_MakeCylinder(3, 20).Solid(), faces);
  add_loose_faces(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1)), 3, 5).Solid(), faces);
  const Sewn sewn = sew_faces(faces, {});
  ASSERT_EQ(sewn.solids.size(), 2u);
  EXPECT_NEAR(volume_of(sewn.solids[0]) + volume_of(sewn.solids[1]), 225.0 * std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace octet
