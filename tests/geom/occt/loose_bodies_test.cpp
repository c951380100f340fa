// SPDX-License-Identifier: BSD-3-Clause
// Loose faces of bodies that touch: which belong together.
#include "geom/occt/loose_bodies.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <gp.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "geom/occt/read_part.h"
#include "geom/occt/sew.h"
#include "geom/occt/shape_measures.h"
#include "tests/support/loose_iges.h"

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
  const auto bodies = LooseBodies(faces_of_a_sandwich()).in_order(1e-6);
  ASSERT_EQ(bodies.size(), 3u);
  for (const auto& body : bodies) EXPECT_EQ(body.size(), 6u);
}

TEST(LooseBodies, NoneWhereFacesOfTwoAreMixedOrOneIsMissing) {
  std::vector<TopoDS_Shape> faces = faces_of_a_sandwich();
  std::swap(faces[2], faces[8]);
  EXPECT_LT(LooseBodies(faces).in_order(1e-6).size(), 3u);
  faces = faces_of_a_sandwich();
  faces.erase(faces.begin() + 7);
  EXPECT_TRUE(LooseBodies(faces).in_order(1e-6).empty());
  faces.resize(6);
  EXPECT_TRUE(LooseBodies(faces).in_order(1e-6).empty()) << "one body";
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

/// Where a box's edges run along a cylinder, what is left of the box is three pieces that touch in two of its
/// edges, as exactly as a cut of surfaces that touch there finds them: ends of edges miss each other by more
/// than faces are sewn within, but not by more than their tolerance.
TEST(LooseBodies, EdgesMayMissEachOtherByTheirTolerance) {
  gp_Trsf turn;
  turn.SetRotation(gp::OZ(), std::numbers::pi / 4.0);
  const double side = 1.0 + std::numbers::sqrt2 / 2.0;
  const TopoDS_Shape box =
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, 0), side, side, 2).Solid(), turn).Shape();
  const TopoDS_Shape pieces = BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(1, 2).Solid()).Shape();
  const auto path = std::filesystem::temp_directory_path() / "octet_LooseBodies.iges";
  ASSERT_TRUE(test::write_loose_iges(pieces, path));
  const Model model = read_part(path);
  std::filesystem::remove(path);
  ASSERT_EQ(model.count(3), 3);
  double volume = 0.0;
  for (int r = 1; r <= 3; ++r) volume += model.region(r).volume;
  EXPECT_NEAR(volume, volume_of(pieces), 1e-6);
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
