// SPDX-License-Identifier: BSD-3-Clause
// Shapes in memory: what is mended, what is refused.
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "base/error.h"
#include "tests/support/notes.h"

namespace octet {
namespace {

std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  std::vector<TopoDS_Shape> parts;
  for (TopExp_Explorer it(shape, type); it.More(); it.Next()) parts.push_back(it.Current());
  return parts;
}

TEST(FromShape, NumbersFacesEdgesAndVerticesAsTheMapOfTheShape) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const Model model = model_from_shape(box);
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(box, TopAbs_VERTEX, vertices);
  ASSERT_EQ(model.count(0), vertices.Extent());
  for (int tag = 1; tag <= model.count(0); ++tag) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(tag)));
    EXPECT_EQ(model.vertex(tag).point, Vec3(p.X(), p.Y(), p.Z()));
  }
}

TEST(FromShape, LeavesTheShapeWithoutTriangulation) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  (void)model_from_shape(box);
  for (const TopoDS_Shape& face : parts_of(box, TopAbs_FACE)) {
    TopLoc_Location place;
    EXPECT_TRUE(BRep_Tool::Triangulation(TopoDS::Face(face), place).IsNull());
  }
}

TEST(FromShape, ASolidsVolumeDoesNotDependOnHowFarOthersAre) {
  // The edges where the cylinders meet lie off them by some 1e-7: seen from far away that is a wide gap.
  const TopoDS_Shape across =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-10, 1, 5), gp_Dir(1, 0.3, 0.2)), 3, 30).Shape();
  const TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(5, 20).Shape(), across).Shape();
  const TopoDS_Shape far = BRepPrimAPI_MakeBox(gp_Pnt(3e7, 2e7, 1e7), 1e6, 1e6, 1e6).Shape();
  const double alone = model_from_shape(part).region(1).volume;
  const Model both = model_from_shape(compound_of({part, far}));
  EXPECT_NEAR(both.region(1).volume, alone, 1e-5 * alone);
  EXPECT_NEAR(both.region(2).volume, 1e18, 1e6);
}

TEST(FromShape, FusesSolidsThatTouch) {
  const Model model = model_from_shape(compound_of(
      {BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 2, 2)).Shape()}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 12);  // the larger side is split in two, of which one is shared
  EXPECT_NEAR(model.region(1).volume, 1.0, 1e-9);
  EXPECT_NEAR(model.region(2).volume, 4.0, 1e-9);
  EXPECT_TRUE(test::has_note(model, "fused"));
}

/// Numbers as read of one dimension that kept their number.
int kept(const Model& model, int dim) {
  int count = 0;
  const auto& entities = model.provenance().as_read[static_cast<std::size_t>(dim)];
  for (std::size_t number = 1; number < entities.size(); ++number)
    for (const int tag : entities[number].tags) count += tag == static_cast<int>(number) ? 1 : 0;
  return count;
}

TEST(FromShape, FusingKeepsEveryNumberButThoseOfWhatWasJoined) {
  const TopoDS_Shape boxes = compound_of(
      {BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 1, 1)).Shape()});
  const Model model = model_from_shape(boxes);
  ASSERT_EQ(model.count(2), 11);
  const auto& faces = model.provenance().as_read[2];
  ASSERT_EQ(faces.size(), 13u);
  // A box begins with its faces of least and of largest x: Face 7 was joined to Face 2, and Face 12, whose
  // number is beyond the count, took its number.
  EXPECT_EQ(kept(model, 2), 10);
  EXPECT_EQ(faces[7].tags, std::vector<int>{2});
  EXPECT_EQ(faces[12].tags, std::vector<int>{7});
  TopTools_IndexedMapOfShape as_read;
  TopExp::MapShapes(boxes, TopAbs_FACE, as_read);
  for (std::size_t number = 1; number < faces.size(); ++number) {
    ASSERT_EQ(faces[number].tags.size(), 1u);
    EXPECT_NEAR(model.face(faces[number].tags[0]).area, 1.0, 1e-12);
  }
  EXPECT_EQ(kept(model, 3), 2);
}

TEST(FromShape, ReportsWhatTwoSolidsBothFill) {
  const Model model = model_from_shape(compound_of(
      {BRepPrimAPI_MakeBox(2, 2, 2).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), gp_Pnt(4, 4, 4)).Shape()}));
  ASSERT_EQ(model.count(3), 3);
  EXPECT_NEAR(model.region(1).volume, 7.0, 1e-9);
  EXPECT_NEAR(model.region(2).volume, 26.0, 1e-9);
  const auto found = overlaps(model.provenance(), 3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].region, 3);
  EXPECT_EQ(found[0].solids, (std::vector<int>{1, 2}));
  EXPECT_NEAR(model.region(3).volume, 1.0, 1e-9);
  EXPECT_TRUE(test::has_note(model, "Solid 1 and Solid 2 overlap"));
}

TEST(FromShape, KeepsSolidsThatTouchApartWhenAsked) {
  ReadOptions options;
  options.fuse = false;
  const Model model =
      model_from_shape(compound_of({BRepPrimAPI_MakeBox(1, 1, 1).Shape(),
                                    BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 1, 1)).Shape()}),
                       options);
  EXPECT_EQ(model.count(2), 12);
  EXPECT_EQ(model.count(0), 16);
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_TRUE(model.face(f).region[0] == 0 || model.face(f).region[1] == 0);
}

TEST(FromShape, LeavesSolidsApartAlone) {
  const Model model = model_from_shape(compound_of(
      {BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(3, 0, 0), gp_Pnt(4, 1, 1)).Shape()}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 12);
  EXPECT_TRUE(model.notes().empty());
}

TEST(FromShape, MakesASolidOfAClosedShell) {
  const auto shells = parts_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_SHELL);
  const Model model = model_from_shape(shells.front());
  EXPECT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-12);
  EXPECT_TRUE(test::has_note(model, "closed shell"));
}

TEST(FromShape, SewsLooseFacesThatFit) {
  std::vector<TopoDS_Shape> faces;
  for (int i = 0; i < 6; ++i) {
    // Each face from its own box: no edge is shared.
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    faces.push_back(parts_of(box, TopAbs_FACE)[static_cast<std::size_t>(i)]);
  }
  const Model model = model_from_shape(compound_of(faces));
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 6);
  EXPECT_EQ(model.count(1), 12);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
  EXPECT_TRUE(test::has_note(model, "sewn"));
}

TEST(FromShape, NamesTheFreeEdgeOfAnOpenShell) {
  auto faces = parts_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE);
  faces.pop_back();
  try {
    (void)model_from_shape(compound_of(faces));
    FAIL() << "an open shell was accepted";
  } catch (const ModelError& error) {
    EXPECT_EQ(error.entity().dim, 1);
    EXPECT_GT(error.entity().tag, 0);
    EXPECT_NE(std::string(error.what()).find("is free"), std::string::npos);
  }
}

TEST(FromShape, LeavesOutFacesBesideASolidWithANote) {
  const auto faces = parts_of(BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), gp_Pnt(6, 1, 1)).Shape(), TopAbs_FACE);
  const Model model = model_from_shape(compound_of({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), faces.front()}));
  EXPECT_EQ(model.count(2), 6);
  EXPECT_TRUE(test::has_note(model, "left out"));
  const auto& left_out = model.provenance().left_out;
  ASSERT_EQ(left_out.size(), 1u);
  EXPECT_EQ(left_out[0].entity, model_face(7));
  EXPECT_NEAR(left_out[0].measure, 1.0, 1e-9);
}

TEST(FromShape, RefusesANullShape) { EXPECT_THROW((void)model_from_shape(TopoDS_Shape()), InputError); }

TEST(FromShape, RefusesFacesThatHaveTrianglesForASurface) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1.0).Shape();
  const BRepMesh_IncrementalMesh mesher(ball, 0.1);
  BRepTools::CleanGeometry(ball);
  try {
    (void)model_from_shape(ball);
    FAIL() << "triangles were accepted";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("Face 1 as read has no surface"), std::string::npos)
        << error.what();
  }
}

TEST(FromShape, DeflectionBoundsTheFacets) {
  ReadOptions fine;
  fine.facet_deflection = 0.01;
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  const Model coarse_model = model_from_shape(ball), fine_model = model_from_shape(ball, fine);
  EXPECT_GE(fine_model.facets().triangles.size(), coarse_model.facets().triangles.size());
  EXPECT_LT(fine_model.facets().deviation[1], 0.04);
}

TEST(FromShape, APartTooFarOffForItsLengthsIsRefusedWithTheVertex) {
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 0, 1e13));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  try {
    (void)model_from_shape(BRepBuilderAPI_Transform(box, away, true).Shape());
    FAIL() << "lengths of 1 mm are lost at 1e13";
  } catch (const ModelError& error) {
    EXPECT_EQ(error.entity().dim, 0);
    EXPECT_NE(std::string(error.what()).find("1e+13"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace octet
