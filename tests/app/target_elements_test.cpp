// SPDX-License-Identifier: BSD-3-Clause
// Numbers of elements that are asked for.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "app/exit_code.h"
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

}  // namespace
}  // namespace octet
