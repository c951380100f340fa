// SPDX-License-Identifier: BSD-3-Clause
// `octet extract` and --write-faults: pieces of parts, and what the file calls what is at fault.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/exit_code.h"
#include "program.h"

namespace octet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

/// A box without the face across from Face 1: no solid, and open.
std::string open_box(const TemporaryDirectory& directory) {
  std::string path = directory.file("open.step");
  const ProgramRun run = run_octet({"extract", model_file("box.step"), "Face1", "-o", path});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  EXPECT_TRUE(has(run.out, "Face1 and 4 face(s) around")) << run.out;
  return path;
}

TEST(PieceCommand, PlacesAreNumbersNamesPointsAndIdsOfTheFile) {
  const TemporaryDirectory directory;
  const std::string part = model_file("bracket.step");
  const auto piece = [&](const std::string& place) {
    const std::string path = directory.file("piece.brep");
    const ProgramRun run = run_octet({"extract", part, place, "-o", path, "-q"});
    EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
    EXPECT_TRUE(run.out.empty());
    return bytes_of(path);
  };
  const Json face = Json::parse(run_octet({"info", part, "--json"}).out)["faces"][4];
  ASSERT_EQ(face["ids"].size(), 1u);
  const std::string wished = piece("Face5");
  EXPECT_GT(wished.size(), 1000u);
  EXPECT_EQ(piece("Face%5"), wished);
  EXPECT_EQ(piece("Face%" + face["ids"][0].get<std::string>()), wished);
  std::ostringstream point;
  point.precision(17);
  point << "Face@" << face["point"][0] << "," << face["point"][1] << "," << face["point"][2];
  EXPECT_EQ(piece(point.str()), wished);
  EXPECT_NE(piece("Face6"), wished);
}

TEST(PieceCommand, TheTableOfEntitiesHasIds) {
  const std::string part = model_file("bracket.step");
  const Json info = Json::parse(run_octet({"info", part, "--json"}).out);
  const std::string table = run_octet({"info", part, "--entities"}).out;
  for (const char* kind : {"regions", "faces", "edges", "vertices"})
    for (const Json& entity : info[kind])
      for (const Json& id : entity["ids"]) EXPECT_TRUE(has(table, "(" + id.get<std::string>() + ")")) << id;
}

TEST(PieceCommand, APartThatIsNoModelHasPiecesToo) {
  const TemporaryDirectory directory;
  const std::string part = open_box(directory), path = directory.file("piece.step");
  const ProgramRun run = run_octet({"extract", part, "Face2", "Edge%1-2", "-o", path, "--around", "0"});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  EXPECT_TRUE(fs::exists(path));
  const ProgramRun named = run_octet({"extract", part, "Face:lid", "-o", path});
  EXPECT_EQ(named.exit_code, kExitBadInput);
  EXPECT_TRUE(has(named.err, "bounds no volume")) << named.err;
}

TEST(PieceCommand, WhatCannotBeMeantIsRefused) {
  const TemporaryDirectory directory;
  const std::string part = model_file("box.step"), path = directory.file("piece.brep");
  EXPECT_EQ(run_octet({"extract", part, "Face1", "-o", directory.file("piece.stl")}).exit_code,
            kExitBadInput);
  EXPECT_EQ(run_octet({"extract", part, "Face7", "-o", path}).exit_code, kExitBadInput);
  EXPECT_EQ(run_octet({"extract", part, "Face%7", "-o", path}).exit_code, kExitBadInput);
  EXPECT_EQ(run_octet({"extract", part, "box:0,0,0,1,1,1", "-o", path}).exit_code, kExitBadInput);
  EXPECT_EQ(run_octet({"extract", part, "Face1", "-o", path, "--around", "-1"}).exit_code, kExitBadInput);
  EXPECT_EQ(run_octet({"extract", part, "-o", path}).exit_code, kExitBadInput);
  EXPECT_EQ(run_octet({"mesh", part, "-o", directory.file("m.msh"), "--write-faults", "f.stl"}).exit_code,
            kExitBadInput);
  const std::string copy = directory.file("copy.step");
  fs::copy_file(part, copy);
  EXPECT_EQ(run_octet({"extract", copy, "Face1", "-o", copy}).exit_code, kExitBadInput);
  EXPECT_EQ(bytes_of(copy), bytes_of(part));
  EXPECT_TRUE(directory.names() == std::vector<std::string>{"copy.step"});
}

TEST(PieceCommand, FaultsOfAPartThatIsNoModelAreWrittenAndHaveIds) {
  const TemporaryDirectory directory;
  const std::string part = open_box(directory), piece = directory.file("faults.brep");
  const ProgramRun run = run_octet({"mesh", part, "-o", directory.file("m.msh"), "--write-faults", piece});
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_TRUE(has(run.err, " is #")) << run.err;
  EXPECT_TRUE(has(run.out, "at fault " + piece)) << run.out;
  EXPECT_TRUE(fs::exists(piece));
  EXPECT_FALSE(fs::exists(directory.file("m.msh")));
}

TEST(PieceCommand, FaultsOfAnAssemblyAreWritten) {
  const TemporaryDirectory directory;
  const std::string piece = directory.file("faults.step"), report = directory.file("report.json");
  const ProgramRun run =
      run_octet({"mesh", model_file("fixture_open_block.step"), "-o", directory.file("m.msh"), "--size", "4",
                 "--write-faults", piece, "--report", report});
  EXPECT_EQ(run.exit_code, kExitIncomplete) << run.err;
  EXPECT_TRUE(has(run.out, "at fault " + piece + ": Face")) << run.out;
  EXPECT_TRUE(has(bytes_of(piece), "ADVANCED_FACE"));
}

TEST(PieceCommand, WithoutFaultsNothingIsWritten) {
  const TemporaryDirectory directory;
  const std::string piece = directory.file("faults.step");
  const ProgramRun run = run_octet({"mesh", model_file("box.step"), "-o", directory.file("m.msh"), "--size",
                                    "10", "--write-faults", piece});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.err;
  EXPECT_TRUE(has(run.out, "nothing of the file is at fault")) << run.out;
  EXPECT_FALSE(fs::exists(piece));
}

}  // namespace
}  // namespace octet
