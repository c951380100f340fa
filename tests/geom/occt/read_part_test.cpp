// SPDX-License-Identifier: BSD-3-Clause
// Files to models: counts, measures, and one clear error for each bad file.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "base/constants.h"
#include "base/error.h"
#include "sample_parts.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

namespace fs = std::filesystem;

/// A file in the test's temporary directory that goes when the test ends.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& content)
      : path_(fs::path(::testing::TempDir()) / ("octet_read_part_" + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { fs::remove(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A sample's file with the text where another stands.
std::string sample_with(const char* name, const std::string& in_place_of, const std::string& text) {
  std::string content = content_of(sample_path(name));
  const std::size_t at = content.find(in_place_of);
  if (at == std::string::npos) throw std::logic_error(in_place_of + " is not in the sample");
  return content.replace(at, in_place_of.size(), text);
}

std::string error_of(const fs::path& path) {
  try {
    (void)read_part(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct Expected {
  const char* name;
  int solids, faces, edges, vertices;
  double volume;
};

class Samples : public ::testing::TestWithParam<Expected> {};

TEST_P(Samples, HaveTheCountsAndVolumeTheyWereMadeWith) {
  const Expected& expected = GetParam();
  const Model model = sample(expected.name);
  EXPECT_EQ(model.count(3), expected.solids);
  EXPECT_EQ(model.count(2), expected.faces);
  EXPECT_EQ(model.count(1), expected.edges);
  EXPECT_EQ(model.count(0), expected.vertices);
  double volume = 0.0;
  for (int tag = 1; tag <= model.count(3); ++tag) volume += model.region(tag).volume;
  EXPECT_NEAR(volume, expected.volume, 1e-7 * expected.volume);
  EXPECT_EQ(model.unit(), "millimetre");
}

INSTANTIATE_TEST_SUITE_P(
    All, Samples,
    ::testing::Values(Expected{"box", 1, 6, 12, 8, 6000.0}, Expected{"two_boxes", 2, 11, 20, 12, 2000.0},
                      Expected{"ball", 1, 1, 3, 2, 4000.0 / 3.0 * kPi},
                      Expected{"cylinder", 1, 3, 3, 2, 500.0 * kPi},
                      Expected{"cone", 1, 2, 3, 2, 2000.0 / 3.0 * kPi},
                      Expected{"torus", 1, 1, 2, 1, 1000.0 * kPi* kPi},
                      Expected{"box_minus_ball", 1, 7, 15, 10, 27000.0 - 4000.0 / 3.0 * kPi},
                      Expected{"plate_with_hole", 1, 7, 15, 10, 1200.0 - 36.0 * kPi}),
    [](const auto& sample) { return std::string(sample.param.name); });

TEST(ReadPart, LengthsAndAreasAreExact) {
  const Model model = sample("cylinder");
  double area = 0.0, length = 0.0;
  for (int tag = 1; tag <= 3; ++tag) area += model.face(tag).area;
  for (int tag = 1; tag <= 3; ++tag) length += model.edge(tag).length;
  EXPECT_NEAR(area, 250.0 * kPi, 1e-6);
  EXPECT_NEAR(length, 20.0 + 20.0 * kPi, 1e-6);
}

TEST(ReadPart, ReadsTheBracketWithItsName) {
  const Model model = sample("bracket");
  EXPECT_EQ(model.count(2), 46);
  EXPECT_NE(model.region(1).name.find("bracket"), std::string::npos);
}

TEST(ReadPart, TellsBrepByContentWhateverTheSuffix) {
  std::ostringstream text;
  BRepTools::Write(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), text);
  const TemporaryFile file("box.txt", text.str());
  const Model model = read_part(file.path());
  EXPECT_EQ(model.count(2), 6);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-12);
}

TEST(ReadPart, ConvertsInchesToMillimetreAndNamesTheUnit) {
  const TemporaryFile file("metre.step",
                           sample_with("box", "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"));
  const Model model = read_part(file.path());
  EXPECT_EQ(model.unit(), "metre");
  EXPECT_NEAR(model.region(1).volume, 6000.0 * 1e9, 1.0);
}

TEST(ReadPart, PassesOverItemsThatTheKernelDoesNotKnow) {
  const TemporaryFile file(
      "callout.step", sample_with("box", "('',(#11,#15),#345);",
                                  "('',(#11,#9001,#15),#345);\n#9001 = LEADER_DIRECTED_CALLOUT('',(#15));"));
  const Model model = read_part(file.path());
  EXPECT_EQ(model.count(2), 6);
  EXPECT_NEAR(model.region(1).volume, 6000.0, 1e-9);
  EXPECT_TRUE(has_note(model, "passed over, for the CAD kernel does not know their kind (texts"));
}

TEST(ReadPart, RefusesAFaceThatIsFarFromWhatIsBetweenItsEdges) {
  // Without its unit of angles the cone's are degrees: the face runs away from its edges.
  const TemporaryFile file(
      "cone.step",
      sample_with("cone", "#84 = ( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) );", ""));
  const std::string error = error_of(file.path());
  EXPECT_NE(error.find("Face 1 lies up to"), std::string::npos) << error;
  EXPECT_NE(error.find("off all triangles between its edges"), std::string::npos) << error;
}

TEST(ReadPart, RefusesASurfaceWithoutExtent) {
  // OCCT reads such a radius as zero; questions about the face then took minutes.
  std::string text = content_of(fs::path(OCTET_MODELS) / "torus.step");
  const std::size_t at = text.find(',', text.find(',', text.find("TOROIDAL_SURFACE")) + 1);
  const std::size_t last = text.find(',', at + 1);
  ASSERT_NE(last, std::string::npos);
  text.replace(last + 1, text.find(')', last) - last - 1, "NaN");
  const TemporaryFile file("nan.step", text);
  EXPECT_NE(error_of(file.path()).find("Face 1 has a surface without extent"), std::string::npos)
      << error_of(file.path());
}

TEST(ReadPart, RefusesWeightsThatDifferByTwelveOrders) {
  // A surface that runs through its corner at 1e12 times the speed of elsewhere: its cuts took minutes.
  std::string text = content_of(fs::path(OCTET_MODELS) / "blade.step");
  const std::size_t at = text.find("RATIONAL_B_SPLINE_SURFACE");
  const std::size_t weight = text.find("1.)", at);
  ASSERT_NE(weight, std::string::npos);
  text.replace(weight, 2, "1.E-12");
  const TemporaryFile file("weights.step", text);
  EXPECT_NE(error_of(file.path()).find("has a spline surface whose weights differ by a factor of 1e+12"),
            std::string::npos)
      << error_of(file.path());
}

TEST(ReadPart, NamesAMissingFile) {
  EXPECT_NE(error_of("/nonexistent/part.step").find("does not exist"), std::string::npos);
}

TEST(ReadPart, RefusesADirectory) {
  EXPECT_NE(error_of(::testing::TempDir()).find("is a directory"), std::string::npos);
}

TEST(ReadPart, RefusesAnEmptyFile) {
  const TemporaryFile file("empty.step", "");
  EXPECT_NE(error_of(file.path()).find("is empty"), std::string::npos);
}

TEST(ReadPart, RefusesPlainText) {
  const TemporaryFile file("text.step", "This is not a CAD file.\n");
  EXPECT_NE(error_of(file.path()).find("is not a STEP, IGES or OpenCASCADE BREP file"), std::string::npos);
}

TEST(ReadPart, RefusesATruncatedStepFileWhereverItIsCut) {
  const std::string text = content_of(sample_path("plate_with_hole"));
  for (const double share : {0.05, 0.3, 0.6, 0.9, 0.99}) {
    const TemporaryFile file("cut.step", text.substr(0, static_cast<std::size_t>(share * text.size())));
    EXPECT_NE(error_of(file.path()).find("is truncated"), std::string::npos) << share;
  }
}

TEST(ReadPart, RefusesAStepFileOfTrianglesAlone) {
  std::string text = content_of(sample_path("box"));
  const std::string face = "ADVANCED_FACE", triangles = "COMPLEX_TRIANGULATED_FACE";
  for (std::size_t at = text.find(face); at != std::string::npos; at = text.find(face, at + triangles.size()))
    text.replace(at, face.size(), triangles);
  const TemporaryFile file("triangles.step", text);
  EXPECT_NE(error_of(file.path()).find("has no faces but triangles"), std::string::npos)
      << error_of(file.path());
}

TEST(ReadPart, ReadsAStepFileOfFacesAndTriangles) {
  std::string text = content_of(sample_path("box"));
  const std::size_t data = text.find("DATA;") + 5;
  text.insert(data, "/* TRIANGULATED_FACE */");
  // The word that counts lies across the ends of the blocks in which the file is searched.
  const std::size_t wanted = (std::size_t{1} << 20) - 5;
  std::string comments;
  while (comments.size() + 64 < wanted - text.find("ADVANCED_FACE"))
    comments += "/*" + std::string(28, ' ') + "*/";
  comments.append(wanted - text.find("ADVANCED_FACE") - comments.size(), ' ');
  text.insert(data, comments);
  ASSERT_EQ(text.find("ADVANCED_FACE"), wanted);
  const TemporaryFile file("both.step", text);
  EXPECT_EQ(read_part(file.path()).count(2), 6);
}

TEST(ReadPart, RefusesATruncatedBrepFile) {
  std::ostringstream text;
  BRepTools::Write(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), text);
  for (const double share : {0.1, 0.4, 0.7}) {
    const TemporaryFile file("cut.brep",
                             text.str().substr(0, static_cast<std::size_t>(share * text.str().size())));
    EXPECT_NE(error_of(file.path()), "no error") << share;
  }
}

TEST(ReadPart, RefusesAStepFileWithoutAnyShape) {
  const TemporaryFile file(
      "header.step",
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  EXPECT_NE(error_of(file.path()).find(file.path().string()), std::string::npos);
}

TEST(ReadPart, PrintsNothing) {
  const TemporaryFile file("header2.step",
                           "ISO-10303-21;\nHEADER;\nDATA;\n#1=X(;\nENDSEC;\nEND-ISO-10303-21;\n");
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  (void)sample("box");
  (void)error_of(file.path());
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace octet::test
