// SPDX-License-Identifier: BSD-3-Clause
// Combs and perforated plates through STEP and back, against what OCCT's reader makes of them by itself.
#include "geom/occt/reader_repairs.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Wire.hxx>
#include <filesystem>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/read_part.h"
#include "geom/occt/silence.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {
namespace {

/// A bar of height 1 with teeth of 1 by 2 on it, a tooth's width apart; 2 deep.
TopoDS_Shape comb(int teeth) {
  BRepBuilderAPI_MakePolygon outline;
  outline.Add(gp_Pnt(2 * teeth - 1, 0, 0));
  outline.Add(gp_Pnt(0, 0, 0));
  for (int i = 0; i < teeth; ++i) {
    if (i > 0) outline.Add(gp_Pnt(2 * i, 1, 0));
    outline.Add(gp_Pnt(2 * i, 3, 0));
    outline.Add(gp_Pnt(2 * i + 1, 3, 0));
    if (i + 1 < teeth) outline.Add(gp_Pnt(2 * i + 1, 1, 0));
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 2)).Shape();
}

/// A plate of 1, with n by n holes of diameter 1 in squares of 2.
TopoDS_Shape perforated_plate(int n) {
  const double side = 2.0 * n;
  BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(side, 0, 0), gp_Pnt(side, side, 0),
                                     gp_Pnt(0, side, 0), true);
  BRepBuilderAPI_MakeFace face(outline.Wire());
  for (int i = 0; i < n * n; ++i) {
    const gp_Ax2 at(gp_Pnt(2 * (i % n) + 1, 2 * (i / n) + 1, 0), -gp::DZ());
    face.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(at, 0.5))).Wire());
  }
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 1)).Shape();
}

void expect_read_as_by_occt(const TopoDS_Shape& shape, double volume) {
  ASSERT_TRUE(has_countless_sides(shape));
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".step");
  TopoDS_Shape read;
  {
    const Silence silence;
    STEPControl_Writer writer;
    ASSERT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    STEPControl_Reader reader;
    ASSERT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    read = reader.OneShape();
  }
  const Model model = read_part(path);
  std::filesystem::remove(path);
  EXPECT_EQ(model.count(2), sub_shapes(read, TopAbs_FACE).Extent());
  EXPECT_EQ(model.count(1), sub_shapes(read, TopAbs_EDGE).Extent());
  EXPECT_EQ(model.count(0), sub_shapes(read, TopAbs_VERTEX).Extent());
  EXPECT_NEAR(model.region(1).volume, volume, 1e-9 * volume);
  EXPECT_EQ(check_model(model), "");
}

TEST(ReaderRepairs, ACombIsReadAsTheReaderWouldReadIt) {
  constexpr int kTeeth = 150;
  expect_read_as_by_occt(comb(kTeeth), 2.0 * (2 * kTeeth - 1) + 4.0 * kTeeth);
}

TEST(ReaderRepairs, APerforatedPlateIsReadAsTheReaderWouldReadIt) {
  constexpr int kHoles = 17;
  expect_read_as_by_occt(perforated_plate(kHoles), kHoles * kHoles * (4.0 - 0.25 * std::numbers::pi));
}

TEST(ReaderRepairs, PartsOfFewSidesAreTheReadersOwn) {
  EXPECT_FALSE(has_countless_sides(comb(100)));
  EXPECT_FALSE(has_countless_sides(perforated_plate(15)));
}

/// The repairs that stay: a loop that is not turned around its hole is.
TEST(ReaderRepairs, ALoopThatIsNotTurnedAroundItsHoleIs) {
  BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0), gp_Pnt(4, 4, 0), gp_Pnt(0, 4, 0),
                                     true);
  BRepBuilderAPI_MakeFace face(outline.Wire());
  const gp_Ax2 at(gp_Pnt(2, 2, 0), gp::DZ());
  face.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(at, 1.0))).Wire());  // not around a hole
  const Handle(ShapeProcess_ShapeContext) context = new ShapeProcess_ShapeContext(face.Face(), "");
  repair_but_for_crossings(face.Face(), 1e-7, 1.0, *context, Message_ProgressRange());
  EXPECT_FALSE(context->Result().IsSame(face.Face()));
}

}  // namespace
}  // namespace octet::test
