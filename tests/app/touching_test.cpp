// SPDX-License-Identifier: BSD-3-Clause
// Faces of solids kept apart that lie on each other, as `octet info --no-fuse` lists them.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "app/exit_code.h"
#include "program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

Json info_of(const std::string& part, const std::string& fuse) {
  const ProgramRun run = run_octet({"info", part, "--json", fuse});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  return Json::parse(run.out);
}

Json touching(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, a);
  builder.Add(both, b);
  const TemporaryDirectory directory;
  const std::string path = directory.file("both.brep");
  EXPECT_TRUE(BRepTools::Write(both, path.c_str()));
  return info_of(path, "--no-fuse")["touching"];
}

TEST(Touching, SolidsKeptApartTouchWhereFusedOnesShareFaces) {
  const Json fused = info_of(model_file("fixture.step"), "--cap");
  const Json apart = info_of(model_file("fixture.step"), "--no-fuse");
  EXPECT_TRUE(fused["touching"].empty());
  EXPECT_TRUE(apart["interfaces"].empty());
  ASSERT_EQ(apart["touching"].size(), fused["interfaces"].size());
  for (std::size_t i = 0; i < fused["interfaces"].size(); ++i) {
    const Json& pair = apart["touching"][i];
    EXPECT_EQ(pair["regions"], fused["interfaces"][i]["regions"]);
    EXPECT_NEAR(pair["area"].get<double>(), fused["interfaces"][i]["area"].get<double>(), 1e-6);
    EXPECT_NEAR(pair["place"][2].get<double>(), 4.0, 1e-9);
    for (std::size_t side = 0; side < 2; ++side)
      EXPECT_EQ(apart["faces"][pair["faces"][side].get<std::size_t>() - 1]["regions"][0],
                pair["regions"][side]);
  }
}

TEST(Touching, FacesThatCoverEachOtherInPartShareThatPart) {
  const Json pairs = touching(BRepPrimAPI_MakeBox(4.0, 3.0, 1.0).Shape(),
                              BRepPrimAPI_MakeBox(gp_Pnt(1.0, 1.0, 1.0), gp_Pnt(6.0, 7.0, 2.0)).Shape());
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0]["area"].get<double>(), 6.0, 1e-9);
}

TEST(Touching, APinTouchesItsHole) {
  const gp_Ax2 axis(gp_Pnt(5, 5, -2), gp_Dir(0, 0, 1));
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(axis, 2.0, 9.0).Shape();
  const TopoDS_Shape plate = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10.0, 10.0, 4.0).Shape(), pin).Shape();
  const Json pairs = touching(plate, pin);
  ASSERT_EQ(pairs.size(), 1u);
  const double area = 2.0 * std::numbers::pi * 2.0 * 4.0;
  EXPECT_NEAR(pairs[0]["area"].get<double>(), area, 0.02 * area);
  const Json& p = pairs[0]["place"];
  EXPECT_NEAR(std::hypot(p[0].get<double>() - 5.0, p[1].get<double>() - 5.0), 2.0, 1e-9);
}

TEST(Touching, NothingTouchesAcrossAGapOrAlongALine) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape();
  EXPECT_TRUE(touching(box, BRepPrimAPI_MakeBox(gp_Pnt(2.001, 0, 0), gp_Pnt(3, 2, 2)).Shape()).empty());
  EXPECT_TRUE(touching(box, BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 0), gp_Pnt(3, 3, 2)).Shape()).empty());
  // A pin with play, within what facets deviate.
  const TopoDS_Shape hole =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 1, -1), gp_Dir(0, 0, 1)), 0.5, 4.0).Shape();
  const TopoDS_Shape pin =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 1, -1), gp_Dir(0, 0, 1)), 0.4998, 4.0).Shape();
  EXPECT_TRUE(touching(BRepAlgoAPI_Cut(box, hole).Shape(), pin).empty());
}

}  // namespace
}  // namespace octet
