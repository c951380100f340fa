// SPDX-License-Identifier: BSD-3-Clause
// Each region is told beside the CAD's, and the one that is least alike by name.
#include "app/region_measures.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"
#include "tests/app/program.h"

namespace octet {
namespace {

/// A block of 20, and a rod of radius 0.1 and height 1 in it.
TopoDS_Shape block_and_rod() {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(20.0, 20.0, 20.0).Shape());
  builder.Add(both, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(9.3, 10.1, 9.7), gp::DZ()), 0.1, 1.0).Shape());
  return both;
}

int rod_in(const Model& model) { return model.region(1).volume < model.region(2).volume ? 1 : 2; }

TEST(RegionMeasures, AreTheAcceptancesBesideTheCads) {
  const Model model = model_from_shape(block_and_rod());
  ASSERT_EQ(model.count(3), 2);
  const int rod = rod_in(model);
  EXPECT_NEAR(size_that_rounds(model, rod), 0.01 * kPi / (2.0 * kPi * 0.1 * 1.1), 1e-6);
  Acceptance acceptance;
  EXPECT_TRUE(region_measures(acceptance, model).empty());
  acceptance.filled = {0.0, rod == 1 ? 0.0 : 7999.0, rod == 1 ? 7999.0 : 0.0};
  const std::vector<RegionMeasure> regions = region_measures(acceptance, model);
  ASSERT_EQ(regions.size(), 2u);
  for (const RegionMeasure& region : regions) {
    EXPECT_EQ(region.volume, region.tag == rod ? 0.0 : 7999.0);
    EXPECT_EQ(region.cad_volume, model.region(region.tag).volume);
  }
  ASSERT_TRUE(least_alike(regions));
  EXPECT_EQ(least_alike(regions)->tag, rod);
  EXPECT_EQ(least_alike(regions)->relative_error(), -1.0);
  EXPECT_FALSE(least_alike({}));
}

/// Each body has its volume under the whole's tag when they are meshed apart, too.
TEST(RegionMeasures, OfBodiesMeshedApartAreTheWholes) {
  ReadOptions options;
  options.fuse = false;
  const Model model = model_from_shape(block_and_rod(), options);
  ASSERT_EQ(model.count(3), 2);
  MeshOptions coarse;
  coarse.size = 5.0;
  const std::vector<RegionMeasure> regions =
      region_measures(mesh_part(model, coarse).report.acceptance, model);
  ASSERT_EQ(regions.size(), 2u);
  for (const RegionMeasure& region : regions) EXPECT_LT(std::abs(region.relative_error()), 0.2);
}

TEST(RegionMeasures, ARodThatIsCoarseIsToldWithASizeThatIsNot) {
  const TemporaryDirectory out;
  const std::string part = out.file("rod.brep"), mesh = out.file("rod.msh"), report = out.file("rod.json");
  ASSERT_TRUE(BRepTools::Write(block_and_rod(), part.c_str()));
  const auto error_of_rod = [&] {
    const nlohmann::json json = nlohmann::json::parse(std::ifstream(report));
    EXPECT_EQ(json["regions"].size(), 2u);
    double sum = 0.0, error = 0.0;
    for (const auto& region : json["regions"]) {
      sum += region["volume"]["mesh"].get<double>();
      if (region["volume"]["cad"] < 1.0) error = region["volume"]["relative_error"];
    }
    EXPECT_NEAR(sum, json["volume"]["mesh"], 1e-9);
    return error;
  };
  const auto coarse =
      run_octet({"mesh", part, "-o", mesh, "--report", report, "--size", "5", "--curvature", "4"});
  ASSERT_EQ(coarse.exit_code, kExitComplete) << coarse.out << coarse.err;
  EXPECT_LT(error_of_rod(), -0.05);
  const std::size_t advice = coarse.out.find("--size-at Region");
  ASSERT_NE(advice, std::string::npos) << coarse.out;
  const std::size_t value = coarse.out.find("Region", advice);
  const std::string at = coarse.out.substr(value, coarse.out.find(' ', value) - value);
  const auto fine = run_octet(
      {"mesh", part, "-o", mesh, "--report", report, "--size", "5", "--curvature", "4", "--size-at", at});
  ASSERT_EQ(fine.exit_code, kExitComplete) << fine.out << fine.err;
  EXPECT_GT(error_of_rod(), -0.05) << at;
  EXPECT_EQ(fine.out.find("--size-at Region"), std::string::npos) << fine.out;
}

}  // namespace
}  // namespace octet
