// SPDX-License-Identifier: BSD-3-Clause
// What `octet quality` promises about its outputs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/exit_code.h"
#include "io/write.h"
#include "mesh/quality.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

class QualityCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_octet({"mesh", model_file("cylinder.step"), "-o", mesh(), "--quiet"}).exit_code,
              kExitComplete);
  }
  [[nodiscard]] std::string mesh() const { return out_.file("a.msh"); }
  TemporaryDirectory out_;
};

TEST_F(QualityCommand, JsonAgreesWithTheMesh) {
  const auto run = run_octet({"quality", mesh(), "--json", "--worst", "4"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  const Json json = Json::parse(run.out);
  const QualitySummary summary = quality_summary(read_mesh(mesh()));
  EXPECT_EQ(json["tets"], summary.tets);
  EXPECT_NEAR(json["all"][0]["least"].get<double>(), summary.min_dihedral * 180.0 / M_PI, 1e-9);
  EXPECT_NEAR(json["all"][2]["mean"].get<double>(), summary.mean_mean_ratio, 1e-9);
  ASSERT_EQ(json["worst"].size(), 4u);
  EXPECT_FALSE(json["worst"][0]["on"].empty());
}

TEST_F(QualityCommand, EdgesAreHeldAgainstTheSizesAskedForThere) {
  const std::string part = model_file("box.step");
  const std::vector<std::string> sizes{"--size", "4", "--size-at", "Face1=0.9"};
  const auto with_sizes = [&](std::vector<std::string> words) {
    words.insert(words.end(), sizes.begin(), sizes.end());
    EXPECT_EQ(run_octet(words).exit_code, kExitComplete);
  };
  with_sizes({"mesh", part, "-o", out_.file("b.msh"), "--quiet"});
  with_sizes({"info", part, "--sizes", "--write-field", out_.file("b.vtu")});
  const auto edges = [&](const std::vector<std::string>& words) {
    return Json::parse(run_octet(words).out)["edges"]["median"].get<double>();
  };
  EXPECT_NEAR(edges({"quality", out_.file("b.msh"), "--json", "--field", out_.file("b.vtu")}), 1.0, 0.1);
  EXPECT_LT(edges({"quality", out_.file("b.msh"), "--json", "--size", "4"}), 0.4);
}

TEST_F(QualityCommand, CsvCountsEveryElementOncePerMeasure) {
  const auto run = run_octet({"quality", mesh(), "--csv"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  std::istringstream lines(run.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "measure,over,from,to,count");
  std::size_t counted = 0;
  while (std::getline(lines, line)) {
    if (line.rfind("mean ratio,all,", 0) == 0) counted += std::stoul(line.substr(line.rfind(',') + 1));
  }
  EXPECT_EQ(counted, quality_summary(read_mesh(mesh())).tets);
}

TEST_F(QualityCommand, TextShowsTableHistogramsAndTheWorst) {
  const auto run = run_octet({"quality", mesh()});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  for (const std::string word : {"smallest dihedral", "largest dihedral", "mean ratio", "radius ratio",
                                 "aspect", "edge length / size", "###", "worst elements", "Region1"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " in " << run.out;
}

TEST_F(QualityCommand, WithoutElementsThatThePartDoesNotLimitThereIsNoSecondTable) {
  const std::string coarse = out_.file("coarse.msh");
  ASSERT_EQ(run_octet({"mesh", model_file("plate_with_hole.step"), "-o", coarse, "--size", "40", "--uniform"})
                .exit_code,
            kExitComplete);
  const auto told = [&](const std::string& size) {
    return run_octet({"quality", coarse, "--size", size}).out;
  };
  EXPECT_NE(told("3").find("mean ratio"), std::string::npos);
  EXPECT_EQ(told("1000").find("without the"), std::string::npos) << told("1000");
}

TEST_F(QualityCommand, BadInputIsOneLine) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"quality", out_.file("none.msh")},
        {"quality", model_file("box.step")},
        {"quality", mesh(), "--size", "-1"},
        {"quality", mesh(), "--json", "--csv"}}) {
    const auto run = run_octet(arguments);
    EXPECT_EQ(run.exit_code, kExitBadInput);
    EXPECT_EQ(run.err.rfind("octet: error: ", 0), 0u) << run.err;
  }
}

}  // namespace
}  // namespace octet
