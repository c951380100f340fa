// SPDX-License-Identifier: BSD-3-Clause
// Pieces of parts have the faces asked for, where they stand, and those about them.
#include "geom/occt/part_piece.h"

#include <gtest/gtest.h>

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

PartPiece piece_of(const std::string& name, const std::vector<ModelRef>& entities, int around,
                   PieceFormat format = PieceFormat::kBrep) {
  return read_piece(sample_path(name), {entities, around, format});
}

TopoDS_Shape shape_of(const PartPiece& piece) {
  std::istringstream in(piece.file);
  TopoDS_Shape shape;
  BRepTools::Read(shape, in, BRep_Builder());
  return shape;
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, type, all);
  return all.Extent();
}

double area(const TopoDS_Shape& shape) {
  GProp_GProps sum;
  BRepGProp::SurfaceProperties(shape, sum);
  return sum.Mass();
}

/// The area of these faces of the model.
double area(const Model& model, const std::vector<int>& faces) {
  double sum = 0.0;
  for (const int f : faces) sum += model.face(f).area;
  return sum;
}

TEST(PartPiece, AFaceAloneIsThatFace) {
  const PartPiece piece = piece_of("box", {model_face(3)}, 0);
  EXPECT_EQ(piece.wished, std::vector<int>{3});
  EXPECT_TRUE(piece.around.empty());
  EXPECT_EQ(count(shape_of(piece), TopAbs_FACE), 1);
  EXPECT_NEAR(area(shape_of(piece)), sample("box").face(3).area, 1e-9);
}

TEST(PartPiece, AboutAFaceOfABoxAreAllButTheOneAcross) {
  const Model box = sample("box");
  for (int f = 1; f <= 6; ++f) {
    const PartPiece piece = piece_of("box", {model_face(f)}, 1);
    ASSERT_EQ(piece.around.size(), 4u);
    EXPECT_NEAR(area(shape_of(piece)), area(box, {1, 2, 3, 4, 5, 6}) - box.face(f).area, 1e-9);
    EXPECT_EQ(piece_of("box", {model_face(f)}, 2).around.size(), 5u);
  }
}

TEST(PartPiece, EdgesAndVerticesBringTheFacesThatTheyLieOn) {
  const Model box = sample("box");
  for (int e = 1; e <= 12; ++e) {
    std::vector<int> faces = box.edge(e).faces;
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(piece_of("box", {model_edge(e)}, 0).wished, faces);
  }
  EXPECT_EQ(piece_of("box", {model_vertex(8)}, 0).wished.size(), 3u);
  EXPECT_EQ(
      piece_of("box", {model_vertex(8), model_face(1), model_face(2), model_edge(1)}, 5).around.size() +
          piece_of("box", {model_vertex(8), model_face(1), model_face(2), model_edge(1)}, 0).wished.size(),
      6u);
}

TEST(PartPiece, ABallIsItsOnlyFace) {
  const PartPiece piece = piece_of("ball", {model_face(1)}, 3);
  EXPECT_EQ(piece.wished, std::vector<int>{1});
  EXPECT_EQ(count(shape_of(piece), TopAbs_FACE), 1);
}

TEST(PartPiece, StandsWhereItStandsInTheAssembly) {
  // The second pin is the first one's part, elsewhere.
  const Model fixture = sample("fixture");
  for (std::size_t number = 1; number <= 4; ++number) {
    const TopoDS_Shape solid = shape_of(piece_of("fixture", {{3, static_cast<int>(number)}}, 1));
    ASSERT_EQ(count(solid, TopAbs_SOLID), 1);
    GProp_GProps content;
    BRepGProp::VolumeProperties(solid, content);
    double volume = 0.0;
    Vec3 moment = Vec3::Zero();
    for (const int tag : fixture.provenance().as_read[3][number].tags) volume += fixture.region(tag).volume;
    EXPECT_NEAR(content.Mass(), volume, 1e-9 * volume);
    const gp_Pnt centre = content.CentreOfMass();
    moment = Vec3(centre.X(), centre.Y(), centre.Z());
    EXPECT_EQ(fixture.region_at(moment), fixture.provenance().as_read[3][number].tags.front());
  }
}

TEST(PartPiece, AStepFileHasNamesAndColoursAndIsTheSameEachTime) {
  const PartPiece piece = piece_of("bracket", {model_face(5)}, 1, PieceFormat::kStep);
  EXPECT_EQ(piece.file, piece_of("bracket", {model_face(5)}, 1, PieceFormat::kStep).file);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "octet_PartPiece.step";
  std::ofstream(path) << piece.file;
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  EXPECT_EQ(count(reader.OneShape(), TopAbs_FACE),
            static_cast<int>(piece.wished.size() + piece.around.size()));
  std::vector<int> all = piece.around;
  all.push_back(5);
  EXPECT_NEAR(area(reader.OneShape()), area(sample("bracket"), all), 1e-6);
  for (const int f : all)
    EXPECT_NE(piece.file.find("'Face" + std::to_string(f) + "'"), std::string::npos) << f;
  EXPECT_NE(piece.file.find("COLOUR"), std::string::npos);
  std::filesystem::remove(path);
}

TEST(PartPiece, WhatIsNotThereIsRefused) {
  EXPECT_THROW((void)piece_of("box", {model_face(7)}, 1), InputError);
  EXPECT_THROW((void)piece_of("box", {{3, 2}}, 1), InputError);
  EXPECT_THROW((void)piece_of("box", {{-1, 0}}, 1), InputError);
  EXPECT_THROW((void)piece_of("box", {{4, 1}}, 1), InputError);
  EXPECT_THROW((void)piece_of("no_such_part", {model_face(1)}, 1), InputError);
}

}  // namespace
}  // namespace octet::test
