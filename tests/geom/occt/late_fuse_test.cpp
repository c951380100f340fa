// SPDX-License-Identifier: BSD-3-Clause
// A solid that others cannot be fused with at once is fused with what became of them; those beyond follow.
#include "geom/occt/late_fuse.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Trsf.hxx>
#include <string>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/fuse.h"
#include "geom/occt/fuse_attempts.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"
#include "tests/geom/occt/solid_in.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Dir& axis, double angle, const gp_Vec& to) {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp::Origin(), axis), angle);
  move.SetTranslation(to);
  return solid_in(BRepBuilderAPI_Transform(shape, move * turn, true).Shape());
}

TopoDS_Shape rounded_cube(double edge, double radius) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(edge, edge, edge).Shape();
  BRepFilletAPI_MakeFillet fillet(cube);
  for (TopExp_Explorer it(cube, TopAbs_EDGE); it.More(); it.Next())
    fillet.Add(radius, TopoDS::Edge(it.Current()));
  return fillet.Shape();
}

/// A ball, a rounded cube and a torus of which each two can be fused, and not the three (OCCT 7.6).
std::vector<TopoDS_Shape> three_at_odds() {
  return {placed(BRepPrimAPI_MakeSphere(1.5).Shape(),
                 gp_Dir(-0.48860598178431069, 0.4792551540636254, 0.72909443275068331), 3.4443185739219189,
                 gp_Vec(-0.5, 0.5, 0.25)),
          placed(rounded_cube(2.0, 0.25), gp::DX(), 0.0, gp_Vec(0, 0.25, -1)),
          placed(BRepPrimAPI_MakeTorus(1.75, 0.5).Shape(),
                 gp_Dir(-0.071434027012484802, -0.088598908396202075, 0.9935025984947301), 5.0303879929706454,
                 gp_Vec(-0.25, 0, -0.25))};
}

double sum_of(const TopTools_ListOfShape& solids) {
  double sum = 0.0;
  for (const TopoDS_Shape& solid : solids) sum += refined_volume_of(solid);
  return sum;
}

TEST(LateFuse, WhatAGroupIsFusedWithoutIsJoinedInTheEnd) {
  const std::vector<TopoDS_Shape> solids = three_at_odds();
  EXPECT_FALSE(best_fuse(solids, 0.0)->sound()) << "else this test needs others";
  SolidSet set{solids, new BRepTools_History(), {}};
  std::vector<KeptApart> apart;
  std::vector<DoneFuse> done;
  fuse_touching(set, 0.0, apart, done);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_TRUE(apart[0].late);
  EXPECT_NEAR(sum_of(images_of(solids[0], set)), 4.0 / 3.0 * kPi * 3.375, 2e-4);
  EXPECT_NEAR(sum_of(images_of(solids[1], set)), refined_volume_of(solids[1]), 2e-4);
  EXPECT_NEAR(sum_of(images_of(solids[2], set)), 2.0 * kPi * kPi * 1.75 * 0.25, 2e-4);
  const Model model = model_from_shape(compound_of(solids));
  EXPECT_TRUE(model.parts().faults.empty());
  const std::vector<int>& pieces = model.provenance().as_read[3][apart[0].solid + 1].tags;
  ASSERT_GT(pieces.size(), 1u);
  EXPECT_TRUE(note_with(model, "could not be fused with all others at once")
                  .starts_with("Region " + std::to_string(pieces.front()) + " "))
      << "the least of what the solid has become";
  EXPECT_EQ(check_model(model), "");
}

TEST(LateFuse, WhatIsKeptApartAgainIsNotTriedAgain) {
  const std::vector<TopoDS_Shape> solids = three_at_odds();
  SolidSet first{solids, new BRepTools_History(), {}};
  std::vector<KeptApart> apart;
  std::vector<DoneFuse> done;
  fuse_touching(first, 0.0, apart, done);
  ASSERT_EQ(apart.size(), 1u);
  const std::size_t fuses = done.size();
  SolidSet again{solids, new BRepTools_History(), {}};
  fuse_touching(again, 0.0, apart, done);
  EXPECT_EQ(again.solids.size(), first.solids.size());
  EXPECT_EQ(done.size(), fuses) << "all are known";
  apart[0].late = false;
  SolidSet parted{solids, new BRepTools_History(), {}};
  fuse_touching(parted, 0.0, apart, done);
  EXPECT_FALSE(apart[0].late);
  EXPECT_LT(parted.solids.size(), first.solids.size());
}

/// Two boxes side by side that share a face, and a third upon the first: what that one cuts changes an edge
/// of the second.
TEST(LateFuse, SolidsBeyondFollowOneForOneOrNothingIsDone) {
  const auto box = [](double x0, double x1, double z0, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, 0, z0), gp_Pnt(x1, 1, z1)).Shape();
  };
  const GroupFuse pair({box(0, 1, 0, 1), box(1, 2, 0, 1)}, {}, 0.0, 1e-6);
  const TopoDS_Shape low = pair.images()[0].front(), beside = pair.images()[1].front();
  EXPECT_EQ(sub_shapes(compound_of(std::vector<TopoDS_Shape>{low, beside}), TopAbs_FACE).Extent(), 11);
  // Ends halfway along the face that the two share: one of its edges becomes two.
  const TopoDS_Shape over = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 1), gp_Pnt(1, 0.5, 2)).Shape();
  EXPECT_FALSE(late_fuse({over, {low}, {}, {beside}}, 0.0)) << "the other cannot follow";
  EXPECT_TRUE(late_fuse({over, {low, beside}, {}, {}}, 0.0)) << "it takes part";
  // Upon the first alone, away from the other.
  const TopoDS_Shape small = BRepPrimAPI_MakeBox(gp_Pnt(0.2, 0.2, 1), gp_Pnt(0.5, 0.5, 2)).Shape();
  const auto fuse = late_fuse({small, {low}, {}, {beside}}, 0.0);
  ASSERT_TRUE(fuse);
  Followers followers(fuse->history());
  const TopoDS_Shape after = followers.follow(beside);
  EXPECT_EQ(sub_shapes(compound_of(std::vector<TopoDS_Shape>{fuse->images()[0].front(), after}), TopAbs_FACE)
                .Extent(),
            12)
      << "six and one under the small box, and the other's five";
}

TEST(LateFuse, WhatLeavesASliverIsFusedWithATolerance) {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)).Shape();
  const TopoDS_Shape over = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 1), gp_Pnt(1, 1 + 8e-7, 2)).Shape();
  EXPECT_GT(GroupFuse({low, over}, {}, 0.0, 1e-6).slivers(), 0) << "else this test needs others";
  const auto fuse = late_fuse({over, {low}, {}, {}}, 0.0);
  ASSERT_TRUE(fuse);
  EXPECT_TRUE(fuse->clean());
  EXPECT_GT(fuse->tolerance(), 0.0);
}

}  // namespace
}  // namespace octet::test
