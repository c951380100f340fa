// SPDX-License-Identifier: BSD-3-Clause
// Faces that solids have alike become one, with the curves that each side's faces need, and nothing else
// does.
#include "geom/occt/common_faces.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/fuse.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

TopoDS_Shape box(double x0, double x1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x0, 0, 0), gp_Pnt(x1, 1, 1)).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by) {
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

gp_Trsf shift(double x) {
  gp_Trsf by;
  by.SetTranslation(gp_Vec(x, 0, 0));
  return by;
}

TopoDS_Shape only_solid(const TopoDS_Shape& shape) { return TopExp_Explorer(shape, TopAbs_SOLID).Current(); }

struct Result {
  SolidSet set;
  int faces = 0;
};
/// Each solid is as valid, and as large, as it was.
Result join(const std::vector<TopoDS_Shape>& solids) {
  Result result{{solids, new BRepTools_History(), {}}, 0};
  join_common_faces(result.set);
  result.faces = ShapeMaps(compound_of(result.set.solids)).of[2].Extent();
  for (const TopoDS_Shape& solid : solids) {
    const TopTools_ListOfShape now = images_of(solid, result.set);
    EXPECT_EQ(now.Extent(), 1);
    EXPECT_TRUE(BRepCheck_Analyzer(now.First()).IsValid());
    EXPECT_NEAR(volume_of(now.First()), volume_of(solid), 1e-6 * volume_of(solid));
  }
  return result;
}

TEST(CommonFaces, OneFaceBoundsBothBoxes) {
  const std::vector<TopoDS_Shape> boxes{box(0, 1), box(1, 2)};
  const Result result = join(boxes);
  EXPECT_EQ(result.faces, 11);
  ASSERT_EQ(result.set.notes.size(), 1u);
  EXPECT_EQ(result.set.notes[0], "1 face(s) that two solids have alike became one each");
  const ShapeMaps now(compound_of(result.set.solids));
  EXPECT_EQ(now.of[1].Extent(), 20);
  EXPECT_EQ(now.of[0].Extent(), 12);
  for (const TopoDS_Shape& solid : boxes)
    for (int dim : {0, 1, 2})
      for (int i = 1; i <= ShapeMaps(solid).of[dim].Extent(); ++i) {
        const TopTools_ListOfShape images = images_of(ShapeMaps(solid).of[dim](i), result.set);
        ASSERT_EQ(images.Extent(), 1);
        EXPECT_TRUE(now.of[dim].Contains(images.First())) << dim << ' ' << i;
      }
}

TEST(CommonFaces, TheShapeGivenIsNotChanged) {
  const std::vector<TopoDS_Shape> boxes{box(0, 1), BRepBuilderAPI_NurbsConvert(box(1, 2)).Shape()};
  const double tolerance = BRep_Tool::Tolerance(TopoDS::Edge(ShapeMaps(boxes[0]).of[1](1)));
  join(boxes);
  EXPECT_EQ(ShapeMaps(compound_of(boxes)).of[2].Extent(), 12);
  for (int i = 1; i <= 12; ++i)
    EXPECT_EQ(BRep_Tool::Tolerance(TopoDS::Edge(ShapeMaps(boxes[0]).of[1](i))), tolerance);
}

TEST(CommonFaces, InstancesOfOneSolidShareWhereTheyMeet) {
  const TopoDS_Shape first = box(0, 1);
  std::vector<TopoDS_Shape> row;
  for (int i = 0; i < 4; ++i) row.push_back(first.Moved(TopLoc_Location(shift(i))));
  EXPECT_EQ(join(row).faces, 21);
}

TEST(CommonFaces, AnEdgeOfManySolidsIsOne) {
  std::vector<TopoDS_Shape> around;
  for (double x : {0.0, 1.0})
    for (double y : {0.0, 1.0})
      around.push_back(BRepPrimAPI_MakeBox(gp_Pnt(x, y, 0), gp_Pnt(x + 1, y + 1, 1)).Shape());
  const Result result = join(around);
  EXPECT_EQ(result.faces, 20);
  EXPECT_EQ(ShapeMaps(compound_of(result.set.solids)).of[1].Extent(), 33);
}

TEST(CommonFaces, APinInItsBoreSharesItSeamOnSeamAndSeamAway) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 0), gp_Pnt(2, 2, 1)).Shape();
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape();
  const TopoDS_Shape bored = only_solid(BRepAlgoAPI_Cut(block, pin).Shape());
  EXPECT_EQ(join({bored, pin}).faces, 7 + 3 - 1);
  EXPECT_EQ(join({pin, bored}).faces, 7 + 3 - 1);
  gp_Trsf turn;
  turn.SetRotation(gp::OZ(), 1.0);
  EXPECT_EQ(join({bored, moved(pin, turn)}).faces, 10) << "other vertices: left to the general fuse";
  for (const TopoDS_Shape& first : {bored, pin}) {
    const TopoDS_Shape& second = first.IsSame(bored) ? pin : bored;
    const Model model = model_from_shape(compound_of({first, second}));
    EXPECT_EQ(model.count(2), 9);
    EXPECT_EQ(check_model(model), "");
  }
}

TEST(CommonFaces, OneBodyTwiceIsOneSolid) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3.0, 1.0).Shape();
  const TopoDS_Shape again = BRepBuilderAPI_Copy(ring).Shape();
  const Result result = join({ring, box(10, 11), again});
  EXPECT_EQ(result.set.solids.size(), 2u);
  EXPECT_TRUE(images_of(again, result.set).First().IsSame(images_of(ring, result.set).First()));
  const Model model = model_from_shape(compound_of({ring, box(10, 11), again}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_TRUE(has_note(model, "Solid 1 and Solid 3 overlap")) << "and it is told";
}

TEST(CommonFaces, LikeEdgesDoNotMakeLikeFaces) {
  // A half ball, and the cone's like: a cylinder's end closes the same circle with a disc.
  const TopoDS_Shape half =
      BRepPrimAPI_MakeSphere(gp_Ax2(gp::Origin(), gp::DZ()), 1.0, 0.0, 0.5 * std::numbers::pi).Shape();
  const TopoDS_Shape stump = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp::DZ()), 1.0, 1.0).Shape();
  EXPECT_EQ(join({half, stump}).faces, 2 + 3 - 1) << "the discs, not the cap";
  // The two halves of one pipe's wall have the same edges but for the seam's side.
  const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
  const auto half_of = [&](double y0, double y1) {
    return only_solid(
        BRepAlgoAPI_Common(bar, BRepPrimAPI_MakeBox(gp_Pnt(-2, y0, 0), gp_Pnt(2, y1, 2)).Shape()).Shape());
  };
  const Result halves = join({half_of(-2, 0), half_of(0, 2)});
  EXPECT_EQ(halves.set.solids.size(), 2u);
  EXPECT_EQ(halves.set.notes[0], "1 face(s) that two solids have alike became one each");
}

TEST(CommonFaces, WhatIsFartherThanTolerancesIsNotAlike) {
  EXPECT_EQ(join({box(0, 1), box(1 + 1e-7, 2)}).faces, 11);
  EXPECT_EQ(join({box(0, 1), box(1 + 1e-5, 2)}).faces, 12);
}

TEST(CommonFaces, ASolidThatIsNotClosedStaysAsItIs) {
  const ShapeMaps whole(box(1, 2));
  std::vector<TopoDS_Shape> faces;
  for (int i = 1; i < whole.of[2].Extent(); ++i) faces.push_back(whole.of[2](i));
  const TopoDS_Solid open = solid_of(faces);
  SolidSet set{{box(0, 1), open}, new BRepTools_History(), {}};
  join_common_faces(set);
  EXPECT_TRUE(set.notes.empty());
  EXPECT_TRUE(set.solids[1].IsSame(open));
}

TEST(CommonFaces, ASolidKeptApartLeavesTheCommonFaceToTheOther) {
  SolidSet set = join({box(0, 1), box(1, 2)}).set;
  std::vector<KeptApart> apart{{1, 1, Vec3::Zero(), "test"}};
  std::vector<DoneFuse> done;
  const ShapeMaps before(compound_of(set.solids));
  SolidSet fused{set.solids, new BRepTools_History(), {}};
  fuse_touching(fused, 0.0, apart, done);
  const ShapeMaps now(compound_of(fused.solids));
  EXPECT_EQ(now.of[2].Extent(), 12);
  int twice = 0;
  for (int i = 1; i <= before.of[2].Extent(); ++i) {
    const TopTools_ListOfShape images = images_of(before.of[2](i), fused);
    for (const TopoDS_Shape& image : images) EXPECT_TRUE(now.of[2].Contains(image)) << i;
    twice += images.Extent() == 2 ? 1 : 0;
  }
  EXPECT_EQ(twice, 1);
}

}  // namespace
}  // namespace octet::test
