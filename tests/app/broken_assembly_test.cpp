// SPDX-License-Identifier: BSD-3-Clause
// An assembly of which one solid is broken: the others are meshed whole, and the broken one is named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "app/exit_code.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

TEST(BrokenAssembly, TheOtherSolidsAreMeshedWholeAndTheBrokenOneIsNamed) {
  const TemporaryDirectory out;
  const std::string part = model_file("fixture_open_block.step");
  const auto run = run_octet({"mesh", part, "-o", out.file("a.msh"), "--report", out.file("a.json")});
  EXPECT_EQ(run.exit_code, kExitIncomplete) << run.err;
  EXPECT_NE(run.out.find("\"block\" is left out"), std::string::npos) << run.out;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  ASSERT_EQ(report["faults"].size(), 1u) << report["faults"];
  EXPECT_NE(report["faults"][0]["cause"].get<std::string>().find("is free"), std::string::npos);
  for (const Json& claim : report["claims"]) EXPECT_TRUE(claim["holds"]) << claim;
  const double pins = 2 * std::numbers::pi * 4 * 10;
  EXPECT_NEAR(report["volume"]["cad"].get<double>(), 40 * 20 * 4 + pins, 1e-6);
  EXPECT_LT(std::abs(report["volume"]["relative_error"].get<double>()), 0.01);
}

TEST(BrokenAssembly, AMeshWithoutTheBrokenSolidIsIncompleteHoweverItIsImprovedOrChecked) {
  const TemporaryDirectory out;
  const std::string part = model_file("fixture_open_block.step");
  const std::string raw = out.file("a.msh"), better = out.file("b.msh"), report = out.file("b.json");
  ASSERT_EQ(run_octet({"mesh", part, "-o", raw, "--no-finalize"}).exit_code, kExitIncomplete);
  const auto improved = run_octet({"improve", raw, part, "-o", better, "--report", report});
  EXPECT_EQ(improved.exit_code, kExitIncomplete) << improved.err;
  EXPECT_NE(improved.out.find("\"block\" is left out"), std::string::npos) << improved.out;
  EXPECT_EQ(Json::parse(read_bytes(report))["status"], "incomplete");
  const auto check = run_octet({"check", better, part});
  EXPECT_EQ(check.exit_code, kExitIncomplete);
  EXPECT_NE(check.out.find("\"block\" is left out"), std::string::npos) << check.out;
  EXPECT_EQ(check.out.find("BROKEN"), std::string::npos) << check.out;
  const Json told = Json::parse(run_octet({"check", better, part, "--json"}).out);
  EXPECT_EQ(told["status"], "incomplete");
  EXPECT_EQ(told["faults"].size(), 1u);
}

}  // namespace
}  // namespace octet
