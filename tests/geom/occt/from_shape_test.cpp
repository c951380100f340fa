// SPDX-License-Identifier: BSD-3-Clause
// Shapes in memory: what is mended, what is refused.
#include "geom/occt/from_shape.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "base/error.h"

namespace octet {
namespace {

TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  std::vector<TopoDS_Shape> parts;
  for (TopExp_Explorer it(shape, type); it.More(); it.Next()) parts.push_back(it.Current());
  return parts;
}

bool any_note(const Model& model, const std::string& words) {
  for (const std::string& note : model.notes())
    if (note.find(words) != std::string::npos) return true;
  return false;
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

TEST(FromShape, FusesSolidsThatTouch) {
  const Model model = model_from_shape(compound_of(
      {BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 2, 2)).Shape()}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 12);  // the larger side is split in two, of which one is shared
  EXPECT_NEAR(model.region(1).volume, 1.0, 1e-9);
  EXPECT_NEAR(model.region(2).volume, 4.0, 1e-9);
  EXPECT_TRUE(any_note(model, "fused"));
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
  EXPECT_TRUE(any_note(model, "closed shell"));
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
  EXPECT_TRUE(any_note(model, "sewn"));
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
  EXPECT_TRUE(any_note(model, "left out"));
}

TEST(FromShape, RefusesANullShape) { EXPECT_THROW((void)model_from_shape(TopoDS_Shape()), InputError); }

TEST(FromShape, DeflectionBoundsTheFacets) {
  ReadOptions fine;
  fine.facet_deflection = 0.01;
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  const Model coarse_model = model_from_shape(ball), fine_model = model_from_shape(ball, fine);
  EXPECT_GE(fine_model.facets().triangles.size(), coarse_model.facets().triangles.size());
  EXPECT_LT(fine_model.facets().deviation[1], 0.04);
}

}  // namespace
}  // namespace octet
