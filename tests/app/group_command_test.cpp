// SPDX-License-Identifier: BSD-3-Clause
// --group: entities by a name of the user's own, in what solvers read.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/exit_code.h"
#include "tests/app/program.h"

namespace octet {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(GroupCommand, PlacesAreThoseOfSizesAndGroupsOfOneNameAreOne) {
  const TemporaryDirectory out;
  const std::string box = model_file("box.step"), deck = out.file("box.inp"), mesh = out.file("box.msh");
  const auto run =
      run_octet({"mesh", box, "-o", deck, "-o", mesh, "--size", "5", "--group", "ends=Face1-2,Face@10,20,30",
                 "--group", "ends=Face2", "--group", "rim=Edge:*"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  const std::string text = text_of(deck);
  const std::size_t at = text.find("*NSET, NSET=ends\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(text.compare(at + 17, 12, "Face1\nFace2\n"), 0);
  EXPECT_NE(text.find("*SURFACE, NAME=ends, TYPE=ELEMENT\n"), std::string::npos);
  EXPECT_NE(text.find("*NSET, NSET=rim\nEdge1\n"), std::string::npos);
  EXPECT_NE(text_of(mesh).find("\"ends\"\n"), std::string::npos);
  // The mesh is what it was.
  const std::string plain = out.file("plain.inp");
  ASSERT_EQ(run_octet({"mesh", box, "-o", plain, "--size", "5"}).exit_code, kExitComplete);
  EXPECT_EQ(text.substr(0, text.find("*NSET, NSET=ends\n")), text_of(plain));
}

TEST(GroupCommand, WhatIsNoGroupIsToldBeforeTheWork) {
  const TemporaryDirectory out;
  const std::string box = model_file("box.step"), deck = out.file("box.inp");
  const std::pair<const char*, const char*> wrong[] = {
      {"Face1", "NAME=PLACE"},           {"=Face1", "NAME=PLACE"},    {"a=", "NAME=PLACE"},
      {"a=box:0,0,0,1,1,1", "of space"}, {"a=Face77", "Face77"},      {"a=Face1,Edge2", "faces and edges"},
      {"a=nothing*", "nothing*"},        {"a=Face1,,Face2", "Face1,"}};
  for (const auto& [text, told] : wrong) {
    const auto run = run_octet({"mesh", box, "-o", deck, "--size", "5", "--group", text});
    EXPECT_EQ(run.exit_code, kExitBadInput) << text;
    EXPECT_NE(run.err.find("--group"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace octet
