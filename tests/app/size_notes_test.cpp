// SPDX-License-Identifier: BSD-3-Clause
// Wishes for sizes that can hardly be meant so are told.
#include "app/size_notes.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include "geom/analytic.h"
#include "geom/size_attributes.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

std::string box() { return model_file("box.step"); }  // 10 x 20 x 30

/// Told of this wish for a box from (0, 0, 0) to (1, 2, 3).
std::vector<std::string> notes_of(const std::string& wish, double size = 1.0) {
  static const Model model = analytic_box(Vec3(1, 2, 3));
  MeshOptions options;
  options.size = size;
  if (!wish.empty()) options.attributes.push_back(parse_size_attribute(wish));
  return size_notes(model, options);
}

TEST(SizeNotes, ShapesOutsideThePartHaveNoEffect) {
  for (const char* wish : {"box:2,0,0,3,1,1=0.1", "ball:-1,-1,-1,1.5=0.1", "cylinder:2,0,0,2,0,3,0.5=0.1"}) {
    const auto notes = notes_of(wish);
    ASSERT_EQ(notes.size(), 1U) << wish;
    EXPECT_NE(notes[0].find(wish), std::string::npos) << notes[0];
  }
  for (const char* wish : {"box:0.9,0,0,3,1,1=0.1", "ball:-1,-1,-1,1.8=0.1", "ball:0.5,1,1,0.01=0.1",
                           "cylinder:-1,1,1,2,1,1,0.01=0.1", "Face1=0.1"})
    EXPECT_TRUE(notes_of(wish).empty()) << wish;
}

TEST(SizeNotes, PointsFarFromThePartAndSizesBeyondItAreTold) {
  EXPECT_EQ(notes_of("Face@25,1,1=0.1").size(), 1U);
  EXPECT_TRUE(notes_of("Face@1.1,1,1=0.1").empty());
  EXPECT_TRUE(notes_of("Face@0.5,1,1.5=0.1").empty());
  EXPECT_EQ(notes_of("", 3.8).size(), 1U);
  EXPECT_TRUE(notes_of("", 3.7).empty());
}

TEST(SizeNotes, AreInTheSummaryTheReportAndTheTableOfSizes) {
  const TemporaryDirectory out;
  write_bytes(out.file("a.csv"), "200,0,0,1\n201,0,0,1\n");
  const std::vector<std::string> wishes{"--size", "5", "--field", out.file("a.csv")};
  const auto with_wishes = [&](std::vector<std::string> words) {
    words.insert(words.end(), wishes.begin(), wishes.end());
    return run_octet(words);
  };
  const ProgramRun mesh =
      with_wishes({"mesh", box(), "-o", out.file("a.msh"), "--report", out.file("a.json")});
  ASSERT_EQ(mesh.exit_code, kExitComplete) << mesh.err;
  const std::string note = "the sizes over space have no effect";
  EXPECT_NE(mesh.out.find("note     " + note), std::string::npos) << mesh.out;
  EXPECT_EQ(Json::parse(read_bytes(out.file("a.json")))["notes"][0].get<std::string>().rfind(note, 0), 0U);
  EXPECT_NE(with_wishes({"info", box(), "--sizes"}).out.find(note), std::string::npos);
  EXPECT_EQ(Json::parse(with_wishes({"info", box(), "--sizes", "--json"}).out)["notes"].size(), 1U);
  write_bytes(out.file("a.csv"), "200,0,0,1\n5,0,0,1\n");
  EXPECT_EQ(with_wishes({"info", box(), "--sizes"}).out.find(note), std::string::npos);
}

}  // namespace
}  // namespace octet
