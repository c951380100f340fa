// SPDX-License-Identifier: BSD-3-Clause
// Options from files: what they may hold, and that the command line goes before them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include "io/write.h"
#include "tests/app/program.h"

namespace octet {
namespace {

std::string box() { return model_file("box.step"); }

ProgramRun mesh_with(std::vector<std::string> options) {
  options.insert(options.begin(), {"mesh", box(), "--size", "5"});
  return run_octet(options);
}

/// The file as the only options besides a size and an output.
ProgramRun mesh_by_file(const TemporaryDirectory& out, const std::string& name, const std::string& bytes) {
  write_bytes(out.file(name), bytes);
  return mesh_with({"-o", out.file("a.msh"), "--config", out.file(name)});
}

TEST(Config, EveryOptionOfTheCommandLinePrevails) {
  const TemporaryDirectory out;
  write_bytes(out.file("c.json"), R"({"order": 1, "unit": "parsec", "format": "none", "threads": 0,
    "max-elements": 1, "report": "/nowhere/a.json", "finalize": "nothing", "defeature": -1, "sew": -1,
    "read-time-limit": -1, "size": -1, "output": "/nowhere/a.msh"})");
  const ProgramRun run = mesh_with({"-o",
                                    out.file("a.msh"),
                                    "--config",
                                    out.file("c.json"),
                                    "--order",
                                    "2",
                                    "--unit",
                                    "mm",
                                    "--format",
                                    "msh",
                                    "--threads",
                                    "1",
                                    "--max-elements",
                                    "1e6",
                                    "--report",
                                    out.file("a.json"),
                                    "--finalize",
                                    "fast",
                                    "--defeature",
                                    "1e-3",
                                    "--sew",
                                    "1e-3",
                                    "--read-time-limit",
                                    "100"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  EXPECT_EQ(out.names(), (std::vector<std::string>{"a.json", "a.msh", "c.json"}));
  EXPECT_FALSE(read_mesh(out.file("a.msh")).mid.of_tets.empty());
}

TEST(Config, AnOptionThatExcludesTheFilesPrevails) {
  const TemporaryDirectory out;
  write_bytes(out.file("c.json"), R"({"fuse-tolerance": 0.1, "finalize": "nicks"})");
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options{"-o", out.file("a.msh"), "--config", out.file("c.json")};
    options.insert(options.end(), more.begin(), more.end());
    return mesh_with(options);
  };
  EXPECT_EQ(run({"--no-fuse", "--fast"}).exit_code, kExitComplete);
  write_bytes(out.file("c.json"), R"({"fast": true, "no-fuse": true})");
  EXPECT_EQ(run({"--fuse-tolerance", "0.1", "--finalize", "nicks"}).exit_code, kExitComplete);
  write_bytes(out.file("c.json"), R"({"fast": true, "finalize": "nicks"})");
  EXPECT_EQ(run({}).exit_code, kExitBadInput);
}

TEST(Config, SizesAtPlacesPrevailPlaceByPlaceAndLaterFilesOverEarlier) {
  const TemporaryDirectory out;
  write_bytes(out.file("c.json"), R"({"size-at": {"Face1": 0.5, "Face2": 1.5}, "order": 3})");
  write_bytes(out.file("d.json"), R"({"order": 1})");
  const auto mesh = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.end(), {"-o", out.file(name)});
    const ProgramRun run = mesh_with(options);
    EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
    return read_bytes(out.file(name));
  };
  EXPECT_TRUE(mesh("a.msh", {"--config", out.file("c.json"), "--config", out.file("d.json"), "--size-at",
                             "Face1=2"}) ==
              mesh("b.msh", {"--size-at", "Face1=2", "--size-at", "Face2=1.5"}));
}

TEST(Config, AnOptionOfOneValueIsGivenOnce) {
  const TemporaryDirectory out;
  for (const char* option : {"--size", "--order", "--growth", "--threads"}) {
    const ProgramRun run = run_octet({"mesh", box(), "-o", out.file("a.msh"), option, "2", option, "1.5"});
    EXPECT_EQ(run.exit_code, kExitBadInput);
    EXPECT_NE(run.err.find(std::string(option) + " is given twice"), std::string::npos) << run.err;
  }
}

TEST(Config, WhatIsNoFileOfOptionsIsToldSoInOneLine) {
  const TemporaryDirectory out;
  for (const std::string& bytes :
       {std::string("[1,2]"), std::string("5"), read_bytes(box()), std::string("\x01\x00\x02{", 4),
        std::string("1,2,3\n"), std::string("{\"size\": \x01}"), std::string("{\"size\": ")}) {
    const ProgramRun run = mesh_by_file(out, "c.json", bytes);
    EXPECT_EQ(run.exit_code, kExitBadInput) << bytes;
    EXPECT_NE(run.err.find(out.file("c.json") + "\" is not a JSON object of options"), std::string::npos)
        << run.err;
  }
}

TEST(Config, KeysThatCannotBeAreNamed) {
  const TemporaryDirectory out;
  const std::vector<std::pair<std::string, std::string>> files{
      {R"({"growth": [1.5, 1.6]})", "\"growth\""},
      {R"({"order": 1, "order": 2})", "\"order\""},
      {R"({"config": "b.json"})", "\"config\""},
      {R"({"help": true})", "\"help\""},
      {R"({"sise": 2})", "did you mean --size?"},
      {R"({"quiet": 1})", "\"quiet\""},
      {R"({"report": true})", "\"report\""},
      {R"({"report": ""})", "\"report\""},
      {R"({"order": null})", "\"order\""},
      {R"({"order": {"a": 1}})", "\"order\""},
      {R"({"size-at": [["Face1=1"]]})", "\"size-at\""},
      {R"({"size-at": {"Face1": 1, "Face1": 2}})", "\"Face1\""}};
  for (const auto& [bytes, told] : files) {
    const ProgramRun run = mesh_by_file(out, "c.json", bytes);
    EXPECT_EQ(run.exit_code, kExitBadInput) << bytes;
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  }
  for (const std::string bytes : {"growth = [1.5, 1.6]\n", "growth = 1.5\norder = 1\ngrowth = 1.6\n",
                                  "[growth]\n", "[growth]\nFace1 = 2\n", "report = true\n"}) {
    const ProgramRun run = mesh_by_file(out, "c.toml", bytes);
    EXPECT_EQ(run.exit_code, kExitBadInput) << bytes;
    EXPECT_NE(run.err.find(bytes[0] == 'r' ? "\"report\"" : "\"growth\""), std::string::npos) << run.err;
  }
}

TEST(Config, AByteOrderMarkIsSkipped) {
  const TemporaryDirectory out;
  for (const auto& [name, bytes] :
       {std::pair("c.json", "{\"quiet\": true}"), {"c.toml", "# none\nquiet = true\n"}}) {
    const ProgramRun run = mesh_by_file(out, name, std::string("\xEF\xBB\xBF") + bytes);
    EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace octet
