// SPDX-License-Identifier: BSD-3-Clause
// Sizes on the command line, from files, and from a previous mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "app/exit_code.h"
#include "io/write.h"
#include "tests/app/edge_lengths.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

std::string box() { return model_file("box.step"); }  // 10 x 20 x 30

double mean_near(const Mesh& mesh, const Vec3& centre, double radius) {
  return test::mean(test::edge_lengths(mesh, mesh.tets, [&](const Vec3& a, const Vec3& b) {
    return std::max((a - centre).norm(), (b - centre).norm()) < radius;
  }));
}

TEST(SizeCommand, ConfigSaysTheSameInJsonAndTomlAndTheCommandLinePrevails) {
  const TemporaryDirectory out;
  write_bytes(out.file("a.json"), R"({"size": 4, "size-at": {"Face1": 1.0, "ball:5,5,5,2": 1.0}})");
  write_bytes(out.file("a.toml"), "size = 4\nsize-at = [\"Face1=1.0\", \"ball:5,5,5,2=1.0\"]\n");
  const auto mesh = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"mesh", box(), "-o", out.file(name), "--quiet"});
    const ProgramRun run = run_octet(options);
    EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
    return read_bytes(out.file(name));
  };
  const std::string words =
      mesh("w.msh", {"--size", "4", "--size-at", "Face1=1", "--size-at", "ball:5,5,5,2=1"});
  EXPECT_TRUE(mesh("j.msh", {"--config", out.file("a.json")}) == words);
  EXPECT_TRUE(mesh("t.msh", {"--config", out.file("a.toml")}) == words);
  write_bytes(out.file("b.toml"), "size = 4\n[size-at]\n\"ball:5,5.0,5,2\" = 1.0\nFace1 = 1.0\n");
  EXPECT_TRUE(mesh("b.msh", {"--config", out.file("b.toml")}) == words);
  EXPECT_FALSE(mesh("o.msh", {"--config", out.file("a.json"), "--size", "5"}) == words);
}

TEST(SizeCommand, WhatMakesNoSenseIsRefusedInOneLine) {
  const TemporaryDirectory out;
  write_bytes(out.file("bad.json"), "{\"size\": ");
  write_bytes(out.file("word.json"), "{\"sise\": 2}");
  write_bytes(out.file("none.toml"), "size = \n");
  write_bytes(out.file("bad.csv"), "1,2,3\n");
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--size-at", "Face99=1"},
                                                  {"--size-at", "Face1"},
                                                  {"--growth", "0.9"},
                                                  {"--curvature", "x"},
                                                  {"--curvature", "1"},
                                                  {"--wall-elements", "-1"},
                                                  {"--target-elements", "0"},
                                                  {"--max-size", "0"},
                                                  {"--config", out.file("none.json")},
                                                  {"--config", out.file("bad.json")},
                                                  {"--config", out.file("word.json")},
                                                  {"--config", out.file("none.toml")},
                                                  {"--field", out.file("bad.csv")},
                                                  {"--field", out.file("none.csv")}}) {
    std::vector<std::string> all{"mesh", box(), "-o", out.file("a.msh")};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramRun run = run_octet(all);
    EXPECT_EQ(run.exit_code, kExitBadInput) << options[0] << " " << options[1];
    EXPECT_EQ(run.err.rfind("octet: error: ", 0), 0u) << run.err;
  }
}

TEST(SizeCommand, MisspeltWordsAreToldWhatTheyMayHaveMeant) {
  const TemporaryDirectory out;
  write_bytes(out.file("a.toml"), "sise = 2\n");
  const auto refusal = [&](const std::string& part, const std::vector<std::string>& options) {
    std::vector<std::string> all{"mesh", part, "-o", out.file("a.msh")};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramRun run = run_octet(all);
    EXPECT_EQ(run.exit_code, kExitBadInput);
    return run.err;
  };
  const auto says = [](const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
  };
  const std::string fixture = model_file("fixture.step");
  EXPECT_TRUE(says(refusal(fixture, {"--curvatur", "12"}), "did you mean --curvature?"));
  EXPECT_TRUE(says(refusal(fixture, {"--config", out.file("a.toml")}), "did you mean --size?"));
  EXPECT_TRUE(says(refusal(fixture, {"--size-at", "Face:saet=1"}), "did you mean \"seat\"?"));
  EXPECT_TRUE(says(refusal(fixture, {"--size-at", "Fase3=1"}), "did you mean \"Face3\"?"));
  EXPECT_TRUE(says(refusal(fixture, {"--size-at", "bal:0,0,0,3=1"}), "did you mean \"ball:0,0,0,3\"?"));
  EXPECT_TRUE(says(refusal(fixture, {"--size-at", "Face900=1"}), "its numbers end at "));
  EXPECT_FALSE(says(refusal(fixture, {"--size-at", "Face900=1"}), "Face%900"));
  // A solid of its own is left out there, and with it the last numbers.
  const std::string open = model_file("fixture_open_block.step");
  EXPECT_TRUE(says(refusal(open, {"--size-at", "Face15=1"}), "Face%15 for the number in the file"));
}

TEST(SizeCommand, AMissingOrMisspeltCommandIsToldWhatItMayHaveBeen) {
  const auto refusal = [](const std::vector<std::string>& words) {
    const ProgramRun run = run_octet(words);
    EXPECT_EQ(run.exit_code, kExitBadInput);
    return run.err;
  };
  EXPECT_NE(refusal({"mehs", box()}).find("did you mean octet mesh?"), std::string::npos);
  EXPECT_NE(refusal({box(), "-o", "a.msh"}).find("did you mean octet mesh " + box() + "?"),
            std::string::npos);
  EXPECT_NE(refusal({"mesh", box()}).find("--output is required; see octet mesh --help"), std::string::npos);
  EXPECT_EQ(refusal({"nonsense"}).find("did you mean"), std::string::npos);
}

TEST(SizeCommand, PointCloudsAreFields) {
  const TemporaryDirectory out;
  write_bytes(out.file("a.csv"), "x,y,z,size\n0,0,0,0.5\n5,10,15,3\n10,20,30,3\n");
  const ProgramRun run = run_octet({"mesh", box(), "-o", out.file("a.msh"), "--size", "3", "--uniform",
                                    "--field", out.file("a.csv"), "--quiet"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  const Mesh mesh = read_mesh(out.file("a.msh"));
  EXPECT_NEAR(mean_near(mesh, Vec3(1, 1, 1), 2.0) / 0.5, 1.0, 0.41);
  EXPECT_NEAR(mean_near(mesh, Vec3(8, 18, 25), 6.0) / 3.0, 1.0, 0.25);
}

TEST(SizeCommand, AdaptGivesEachElementsPlaceTheSizeItWants) {
  const TemporaryDirectory out;
  ASSERT_EQ(run_octet({"mesh", box(), "-o", out.file("a.msh"), "--size", "3", "--quiet"}).exit_code,
            kExitComplete);
  const Mesh before = read_mesh(out.file("a.msh"));
  std::ofstream sizes(out.file("size.csv"));
  for (const auto& t : before.tets) {
    double z = 0.0;
    for (const Mesh::Index v : t) z += 0.25 * before.points[v].z();
    sizes << (z < 8.0 ? 1.0 : 4.0) << "\n";
  }
  sizes.close();
  const ProgramRun run = run_octet({"adapt", out.file("a.msh"), box(), "-o", out.file("b.msh"), "--uniform",
                                    "--field", out.file("size.csv"), "--quiet"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  const Mesh after = read_mesh(out.file("b.msh"));
  EXPECT_NEAR(mean_near(after, Vec3(5, 10, 3), 4.0) / 1.0, 1.0, 0.25);
  EXPECT_NEAR(mean_near(after, Vec3(5, 10, 24), 8.0) / 4.0, 1.0, 0.3);
}

TEST(SizeCommand, AdaptRefusesAMeshOfAnotherPartAndTakesCoarseOnesOfThisOne) {
  const TemporaryDirectory out;
  write_bytes(out.file("a.csv"), "0,0,0,3\n10,10,10,3\n");
  const auto adapt = [&](const std::string& mesh, const std::string& part,
                         const std::vector<std::string>& more) {
    std::vector<std::string> words{"adapt",           mesh,      model_file(part), "-o",
                                   out.file("b.msh"), "--field", out.file("a.csv")};
    words.insert(words.end(), more.begin(), more.end());
    return run_octet(words);
  };
  const auto mesh = [&](const std::string& part, const std::string& size, const std::string& order) {
    const ProgramRun run = run_octet(
        {"mesh", model_file(part), "-o", out.file("a.msh"), "--size", size, "--order", order, "--uniform"});
    EXPECT_NE(run.exit_code, kExitBadInput) << run.err;
    return out.file("a.msh");
  };
  const ProgramRun other = adapt(mesh("l_domain.step", "2", "1"), "box.step", {});
  EXPECT_EQ(other.exit_code, kExitBadInput);
  EXPECT_NE(other.err.find("the mesh is none of this part"), std::string::npos) << other.err;
  EXPECT_EQ(adapt(out.file("none.msh"), "box.step", {}).exit_code, kExitBadInput);
  write_bytes(out.file("view.msh"), "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  const ProgramRun unread = adapt(out.file("view.msh"), "box.step", {});
  EXPECT_NE(unread.out.find("was not asked"), std::string::npos) << unread.out << unread.err;
  // In the same box, but with a hole of half its volume.
  const ProgramRun hollow =
      adapt(mesh("box_minus_ball.step", "0.5", "1"), "box_minus_ball.step", {"--unit", "inch"});
  EXPECT_EQ(hollow.exit_code, kExitBadInput);
  EXPECT_EQ(adapt(mesh("ball.step", "30", "1"), "ball.step", {}).exit_code, kExitComplete);
  EXPECT_EQ(adapt(mesh("torus.step", "20", "2"), "torus.step", {}).exit_code, kExitComplete);
}

TEST(SizeCommand, AWrittenFieldGivesTheSameSizesAsAField) {
  const TemporaryDirectory out;
  const ProgramRun info = run_octet({"info", box(), "--sizes", "--json", "--size", "4", "--size-at",
                                     "Vertex@0,0,0=0.5", "--write-field", out.file("a.vtu")});
  ASSERT_EQ(info.exit_code, kExitComplete) << info.err;
  const ProgramRun run = run_octet({"mesh", box(), "-o", out.file("a.msh"), "--size", "4", "--uniform",
                                    "--field", out.file("a.vtu"), "--quiet"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  const Mesh mesh = read_mesh(out.file("a.msh"));
  EXPECT_NEAR(mean_near(mesh, Vec3::Zero(), 1.0) / 0.5, 1.0, 0.25);
  EXPECT_NEAR(mean_near(mesh, Vec3(5, 10, 24), 8.0) / 4.0, 1.0, 0.25);
  const double estimate = Json::parse(info.out)["estimated_elements"].get<double>();
  EXPECT_NEAR(estimate / static_cast<double>(mesh.tets.size()), 1.0, 0.4);
}

TEST(SizeCommand, InfoTakesSizesOnlyToTellOfThem) {
  const ProgramRun run = run_octet({"info", box(), "--size", "4"});
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_NE(run.err.find("--size requires --sizes"), std::string::npos) << run.err;
  const TemporaryDirectory out;
  EXPECT_EQ(run_octet({"info", box(), "--write-field", out.file("b.vtu")}).exit_code, kExitBadInput);
  const ProgramRun other = run_octet({"info", box(), "--sizes", "--write-field", out.file("b.csv")});
  EXPECT_EQ(other.exit_code, kExitBadInput);
  EXPECT_NE(other.err.find("must end in .vtu"), std::string::npos) << other.err;
  EXPECT_TRUE(out.names().empty());
}

TEST(SizeCommand, TargetElementsAreMetWithinFifteenPercent) {
  const TemporaryDirectory out;
  for (const auto& [part, target] :
       {std::pair<std::string, int>{"ball.step", 8000}, {"bracket.step", 20000}, {"torus.step", 8000}}) {
    const ProgramRun run =
        run_octet({"mesh", model_file(part), "-o", out.file("a.msh"), "--report", out.file("a.json"),
                   "--target-elements", std::to_string(target), "--quiet"});
    ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
    EXPECT_NEAR(Json::parse(read_bytes(out.file("a.json")))["tets"].get<double>() / target, 1.0, 0.15)
        << part;
  }
}

TEST(SizeCommand, WhatOtherSizesTookIsTold) {
  const TemporaryDirectory out;
  int tried_again = 0;
  for (const int target : {3000, 9000, 30000, 70000}) {
    const ProgramRun run =
        run_octet({"mesh", model_file("bracket.step"), "-o", out.file("a.msh"), "--report",
                   out.file("a.json"), "--target-elements", std::to_string(target), "--verbose"});
    ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
    std::size_t makings = 0;
    for (std::size_t at = 0; (at = run.err.find("] octree", at)) != std::string::npos; ++at) ++makings;
    const Json times = Json::parse(read_bytes(out.file("a.json")))["times"];
    const auto rest = std::find_if(times.begin(), times.end(),
                                   [](const Json& stage) { return stage["stage"] == "other tries"; });
    EXPECT_EQ(rest != times.end(), makings > 1) << run.err;
    if (rest == times.end()) continue;
    EXPECT_GT((*rest)["seconds"].get<double>(), 0.0);
    ++tried_again;
  }
  EXPECT_GT(tried_again, 0);
}

TEST(SizeCommand, InfoTellsTheSizesAndWhy) {
  const Json info = Json::parse(
      run_octet({"info", box(), "--sizes", "--json", "--size", "25", "--size-at", "Face2=1"}).out);
  EXPECT_EQ(info["size"].get<double>(), 25.0);
  bool asked = false, near = false;
  for (const Json& entity : info["entities"]) {
    if (entity["dim"] == 2 && entity["tag"] == 2)
      asked = entity["why"] == "asked for" && entity["size"].get<double>() == 1.0 &&
              std::abs(entity["gets"].get<double>() - 1.0) < 0.15;
    near |= entity["dim"] == 1 && entity["size"].get<double>() == 10.0;
  }
  EXPECT_TRUE(asked && near) << info.dump();
}

}  // namespace
}  // namespace octet
