// SPDX-License-Identifier: BSD-3-Clause
// Numbers of elements that are asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "app/exit_code.h"
#include "app/target_elements.h"
#include "geom/occt/read_part.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

TEST(TargetElements, ATargetThatIsMissedIsToldWithTheReason) {
  const TemporaryDirectory out;
  const auto report = [&](const std::string& part, const std::string& target) {
    const ProgramRun run = run_octet({"mesh", model_file(part), "-o", out.file("a.msh"), "--report",
                                      out.file("a.json"), "--target-elements", target});
    EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
    const Json json = Json::parse(read_bytes(out.file("a.json")));
    EXPECT_EQ(json["target_elements"].get<double>(), std::stod(target));
    for (const Json& note : json["notes"])
      EXPECT_NE(run.out.find(note.get<std::string>()), std::string::npos);
    return json;
  };
  const auto expect_note = [](const Json& missed, const std::string& begin, const std::string& end) {
    const std::string note = missed["notes"].at(0).get<std::string>();
    EXPECT_EQ(note.rfind(begin, 0), 0U) << note;
    EXPECT_TRUE(note.ends_with(end)) << note;
  };
  expect_note(report("box.step", "5"), "5 tetrahedra were asked for, the mesh has ",
              "however large the size");
  expect_note(report("bracket.step", "100"), "100 tetrahedra were asked for, the mesh has ", "has faults");
  EXPECT_TRUE(report("bracket.step", "9000")["notes"].empty());
}

TEST(TargetElements, FewMeshesFindANumberThatFeaturesDecide) {
  // Numbers as parts with many features have them: they fall with next to no power of the size, and the
  // octrees, of a plain box here, promise that they fall with its square or cube.
  const Model box = read_part(std::filesystem::path(model_file("box.step")));
  MeshOptions options;
  options.target_elements = 30000;
  for (const double power : {0.7, 1.0, 1.5, 3.0}) {
    int meshes = 0;
    const auto mesh = [&](const MeshOptions& with) {
      ++meshes;
      MeshResult result;
      result.report.status = MeshStatus::kComplete;
      result.report.tets = static_cast<std::size_t>(20000.0 + 50000.0 * std::pow(1.0 / with.size, power));
      return result;
    };
    const MeshResult found = mesh_to_target(box, options, mesh);
    EXPECT_NEAR(static_cast<double>(found.report.tets), 30000.0, 3750.0) << power;
    EXPECT_LE(meshes, 5) << power;
  }
}

}  // namespace
}  // namespace octet
