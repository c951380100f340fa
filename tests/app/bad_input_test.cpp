// SPDX-License-Identifier: BSD-3-Clause
// Every way to misuse the program ends within seconds, in one clear line, without a file.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>

#include "app/exit_code.h"
#include "tests/app/program.h"

namespace octet {
namespace {

constexpr double kSeconds = 10.0;  // on a loaded machine; a fraction of a second on an idle one

/// One line on stderr that begins as all errors do and holds `cause`; nothing on stdout.
void expect_error(const ProgramRun& run, int exit_code, const std::string& cause) {
  EXPECT_EQ(run.exit_code, exit_code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("octet: error: ", 0), 0u) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(cause), std::string::npos) << "wanted \"" << cause << "\" in: " << run.err;
  EXPECT_LT(run.seconds, kSeconds);
}

/// The part cannot be used: `octet mesh` and `octet info` say so, and nothing is left behind.
void expect_bad_part(const std::string& part, const std::string& cause) {
  const TemporaryDirectory out;
  expect_error(run_octet({"mesh", part, "-o", out.file("mesh.msh")}), kExitBadInput, cause);
  EXPECT_TRUE(out.names().empty()) << out.names().front();
  expect_error(run_octet({"info", part}), kExitBadInput, cause);
}

void expect_bad_options(const std::vector<std::string>& options, const std::string& cause) {
  const TemporaryDirectory out;
  std::vector<std::string> arguments{"mesh", model_file("bracket.step"), "-o", out.file("mesh.msh")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  expect_error(run_octet(arguments), kExitBadInput, cause);
  EXPECT_TRUE(out.names().empty()) << out.names().front();
}

/// Five of the six faces of a box.
void write_open_box(const std::string& path) {
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  int face = 0;
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), TopAbs_FACE); it.More(); it.Next())
    if (face++ > 0) builder.Add(shell, it.Current());
  ASSERT_TRUE(BRepTools::Write(shell, path.c_str()));
}

TEST(BadInput, EmptyFileIsNamed) {
  const TemporaryDirectory in;
  write_bytes(in.file("empty.step"), "");
  expect_bad_part(in.file("empty.step"), "empty");
}

TEST(BadInput, TruncatedStepIsRefused) {
  const TemporaryDirectory in;
  const std::string whole = read_bytes(model_file("bracket.step"));
  ASSERT_GT(whole.size(), 1000u);
  write_bytes(in.file("cut.step"), whole.substr(0, whole.size() / 2));
  expect_bad_part(in.file("cut.step"), "cut.step");
}

TEST(BadInput, TextIsNoCadFile) {
  const TemporaryDirectory in;
  write_bytes(in.file("text.step"), "Dear reader,\nthis is no part.\n");
  expect_bad_part(in.file("text.step"), "text.step");
}

TEST(BadInput, DirectoryIsNoPart) {
  const TemporaryDirectory in;
  expect_bad_part(in.path().string(), "directory");
}

TEST(BadInput, MissingFileIsNamed) { expect_bad_part("/nowhere/part.step", "/nowhere/part.step"); }

TEST(BadInput, OpenShellNamesAFreeEdge) {
  const TemporaryDirectory in;
  write_open_box(in.file("open.brep"));
  expect_bad_part(in.file("open.brep"), "Edge ");
}

TEST(BadInput, MissingMeshFileIsNamed) {
  const ProgramRun run = run_octet({"check", "/nowhere/mesh.msh", model_file("bracket.step")});
  expect_error(run, kExitBadInput, "/nowhere/mesh.msh");
}

TEST(BadSize, ZeroIsRefused) { expect_bad_options({"--size", "0"}, "--size"); }
TEST(BadSize, NegativeIsRefused) {
  expect_bad_options({"--size", "-1"}, "--size");
  expect_bad_options({"--size=-1"}, "--size");
}
TEST(BadSize, NanIsRefused) { expect_bad_options({"--size", "nan"}, "--size"); }
TEST(BadSize, InfinityIsRefused) { expect_bad_options({"--size", "inf"}, "--size"); }
TEST(BadSize, WordIsRefused) { expect_bad_options({"--size", "small"}, "--size"); }
TEST(BadSize, MinSizeAboveSizeIsRefused) {
  expect_bad_options({"--size", "1", "--min-size", "2"}, "--min-size");
}
TEST(BadSize, MoreElementsThanAllowedAreRefusedBeforeTheyAreMade) {
  expect_bad_options({"--size", "0.001"}, "--max-elements");
  expect_bad_options({"--max-elements", "10"}, "raise --max-elements");
  expect_bad_options({"--max-elements", "1e11"}, "--max-elements may be 4294967295 at most");
}

TEST(BadSize, ALimitThatCannotBeRaisedIsNotSaidToBe) {
  const TemporaryDirectory out;
  const ProgramRun run = run_octet({"mesh", model_file("box.step"), "-o", out.file("a.msh"), "--size", "1e-3",
                                    "--max-elements", "4294967295"});
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_NE(run.err.find("ask for a larger size"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("raise"), std::string::npos) << run.err;
}

TEST(BadSize, PlacesFarTooFineAreRefusedByTheirOwnWordsBeforeTheyAreSampled) {
  const std::string more = " elements, more than the limit of 2e+07: ask for about ";
  expect_bad_options({"--size-at", "Face1=1e-6"}, "Face1=1e-6 asks for about ");
  expect_bad_options({"--size-at", "Face1=1e-6"}, more);
  expect_bad_options({"--size", "3", "--size-at", "box:0,0,0,50,50,50=0.01"}, more);
  expect_bad_options({"--size-at", "Vertex1=1e-6"}, "Vertex1=1e-6 is too small");
}

TEST(BadUse, UnknownUnitFormatAndOptionAreRefused) {
  expect_bad_options({"--unit", "parsec"}, "parsec");
  expect_bad_options({"--format", "ply"}, "ply");
  expect_bad_options({"--format", "su2", "--order", "2"}, "su2");
  expect_bad_options({"--format", "stl", "--order", "2"}, "stl");
  expect_bad_options({"--frobnicate"}, "--frobnicate");
  expect_bad_options({"--threads", "0"}, "--threads");
}

TEST(BadUse, ReadingBeyondItsLimitsIsRefusedAndNamesTheLimit) {
  expect_bad_options({"--read-time-limit", "0.001"}, "took too long: the limit for reading is 0.001 s");
  expect_bad_options({"--read-memory-limit", "0.001"},
                     "needs too much memory: the limit for reading is 0.001 GB");
  expect_bad_options({"--read-time-limit", "-1"}, "--read-time-limit");
}

TEST(BadUse, NoCommandIsRefused) { expect_error(run_octet({}), kExitBadInput, "--help"); }

TEST(BadUse, OutputOverThePartIsRefused) {
  const TemporaryDirectory out;
  const std::string part = out.file("part.msh");
  const std::string bytes = read_bytes(model_file("bracket.step"));
  write_bytes(part, bytes);
  expect_error(run_octet({"mesh", part, "-o", part}), kExitBadInput, "same file");
  EXPECT_EQ(read_bytes(part), bytes);
}

TEST(BadOutput, MissingDirectoryIsNamed) {
  const auto run = run_octet({"mesh", model_file("bracket.step"), "-o", "/nowhere/mesh.msh"});
  expect_error(run, kExitBadInput, "\"/nowhere\" does not exist");
}

TEST(BadOutput, DirectoryIsRefused) {
  const TemporaryDirectory out;
  std::filesystem::create_directory(out.path() / "mesh.msh");
  const auto run = run_octet({"mesh", model_file("bracket.step"), "-o", out.file("mesh.msh")});
  expect_error(run, kExitBadInput, "it is a directory");
}

TEST(BadOutput, FileAsDirectoryIsRefused) {
  const TemporaryDirectory out;
  write_bytes(out.file("file"), "kept");
  const auto run = run_octet({"mesh", model_file("bracket.step"), "-o", out.file("file/mesh.msh")});
  expect_error(run, kExitBadInput, "mesh.msh");
  EXPECT_EQ(read_bytes(out.file("file")), "kept");
}

TEST(BadOutput, PlaceWhereNoFileCanBeMadeIsRefused) {
  const auto run = run_octet({"mesh", model_file("bracket.step"), "-o", "/proc/mesh.msh"});
  expect_error(run, kExitBadInput, "/proc/mesh.msh");
}

TEST(BadOutput, UnwritableReportIsRefusedBeforeMeshing) {
  const TemporaryDirectory out;
  const auto run = run_octet(
      {"mesh", model_file("bracket.step"), "-o", out.file("mesh.msh"), "--report", "/nowhere/report.json"});
  expect_error(run, kExitBadInput, "/nowhere");
  EXPECT_TRUE(out.names().empty());
}

TEST(BadOutput, FullDeviceIsReported) {
  const auto run =
      run_octet({"mesh", model_file("bracket.step"), "-o", "/dev/full", "--format", "msh", "--quiet"});
  expect_error(run, kExitBadInput, "No space left on device");
}

TEST(BadOutput, DiskThatFillsUpLeavesNoFileAndTheOldOneAsItWas) {
  const TemporaryDirectory out;
  write_bytes(out.file("mesh.msh"), "old");
  ProgramLimits limits;
  limits.file_bytes = 8192;
  const auto run =
      run_octet({"mesh", model_file("bracket.step"), "-o", out.file("mesh.msh"), "--quiet"}, limits);
  expect_error(run, kExitBadInput, "mesh.msh");
  EXPECT_EQ(out.names(), std::vector<std::string>{"mesh.msh"});
  EXPECT_EQ(read_bytes(out.file("mesh.msh")), "old");
}

}  // namespace
}  // namespace octet
