// SPDX-License-Identifier: BSD-3-Clause
// What a file itself calls its entities is known of the model's.
#include "geom/occt/file_ids.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <IGESControl_Writer.hxx>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "base/error.h"
#include "geom/size_attributes.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The #numbers of all entities of a type in a STEP file.
std::set<int> numbers_of(const std::string& step, const std::string& type) {
  std::set<int> numbers;
  const std::regex line("#([0-9]+)\\s*=\\s*" + type + "\\s*\\(");
  for (std::sregex_iterator it(step.begin(), step.end(), line), end; it != end; ++it)
    numbers.insert(std::stoi((*it)[1]));
  return numbers;
}

std::set<int> ids(const Model& model, std::size_t dim) {
  std::set<int> found;
  const auto& entities = model.provenance().as_read[dim];
  for (std::size_t n = 1; n < entities.size(); ++n) found.insert(entities[n].id);
  return found;
}

TEST(FileIds, OfAStepFileAreItsNumbers) {
  for (const char* name : {"bracket", "box_minus_ball", "torus"}) {
    const std::string step = text_of(sample_path(name));
    const Model model = sample(name);
    EXPECT_EQ(model.provenance().id_mark, "#");
    std::set<int> vertices = ids(model, 0), in_file = numbers_of(step, "VERTEX_POINT");
    vertices.erase(0);  // a pole where the file has a loop of one vertex
    const std::regex loop("VERTEX_LOOP\\s*\\(\\s*'[^']*'\\s*,\\s*#([0-9]+)");
    for (std::sregex_iterator it(step.begin(), step.end(), loop), end; it != end; ++it)
      in_file.erase(std::stoi((*it)[1]));
    EXPECT_EQ(vertices, in_file) << name;
    EXPECT_EQ(ids(model, 2), numbers_of(step, "ADVANCED_FACE")) << name;
    // A void makes it a BREP_WITH_VOIDS.
    std::set<int> solids = numbers_of(step, "MANIFOLD_SOLID_BREP");
    solids.merge(numbers_of(step, "BREP_WITH_VOIDS"));
    EXPECT_EQ(ids(model, 3), solids) << name;
    std::set<int> edges = ids(model, 1);
    edges.erase(0);  // the poles of a ball are no edges of the file
    EXPECT_EQ(edges, numbers_of(step, "EDGE_CURVE")) << name;
  }
}

TEST(FileIds, FindWhatThePlaceOfAnEntityIs) {
  // The lines of a plane face's definition lead to where it lies: #face = ADVANCED_FACE('',(..),#plane,.T.).
  const std::string step = text_of(sample_path("box"));
  const Model model = sample("box");
  const auto refers_to = [&](int id, const std::string& pattern) {
    std::smatch match;
    const std::regex line("#" + std::to_string(id) + "\\s*=\\s*" + pattern);
    return std::regex_search(step, match, line) ? std::stoi(match[1]) : 0;
  };
  for (int n = 1; n <= 8; ++n) {
    const int id = model.provenance().as_read[0][static_cast<std::size_t>(n)].id;
    const int point = refers_to(id, "VERTEX_POINT\\s*\\(\\s*'[^']*'\\s*,\\s*#([0-9]+)");
    std::smatch match;
    const std::regex line("#" + std::to_string(point) +
                          "\\s*=\\s*CARTESIAN_POINT\\s*\\(\\s*'[^']*'\\s*,\\s*\\(([^,]+),([^,]+),([^)]+)\\)");
    ASSERT_TRUE(std::regex_search(step, match, line)) << id;
    const Vec3 place(std::stod(match[1]), std::stod(match[2]), std::stod(match[3]));
    EXPECT_LT((place - model.vertex(n).point).norm(), 1e-12);
  }
}

TEST(FileIds, AreOnePerPartHoweverOftenItIsUsed) {
  const Model model = sample("fixture");
  const auto& solids = model.provenance().as_read[3];
  ASSERT_EQ(solids.size(), 5u);
  EXPECT_EQ(ids(model, 3).size(), 3u) << "plate, block and two uses of the pin";
  std::multiset<std::size_t> uses;
  for (const int id : ids(model, 3)) {
    EXPECT_GT(id, 0);
    uses.insert(selected_entities(model, parse_size_attribute("Solid%#" + std::to_string(id) + "=1")).size());
  }
  EXPECT_EQ(uses, (std::multiset<std::size_t>{1, 1, 2}));
  EXPECT_THROW((void)selected_entities(model, parse_size_attribute("Face%#1=1")), InputError);
  EXPECT_THROW(
      (void)selected_entities(model, parse_size_attribute("Solid%D" + std::to_string(solids[1].id) + "=1")),
      InputError)
      << "no IGES file";
}

TEST(FileIds, OfAnIgesFileAreLinesOfItsDirectory) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "octet_FileIds.igs";
  IGESControl_Writer writer("MM", 1);  // solids as such
  ASSERT_TRUE(writer.AddShape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()));
  ASSERT_TRUE(writer.Write(path.c_str()));
  const Model model = read_part(path);
  EXPECT_EQ(model.provenance().id_mark, "D");
  // Entity 510 is a face; the directory has two lines an entity, which end in D and a number.
  std::set<int> faces;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
    if (line.size() >= 80 && line[72] == 'D' && std::stoi(line.substr(0, 8)) == 510)
      if (const int number = std::stoi(line.substr(73, 7)); number % 2 == 1) faces.insert(number);
  EXPECT_EQ(faces.size(), 6u);
  EXPECT_EQ(ids(model, 2), faces);
  std::filesystem::remove(path);
}

TEST(FileIds, ABrepFileHasNone) {
  const std::filesystem::path path = std::filesystem::path(OCTET_MODELS) / "bugs" / "crossed_sides.brep";
  const Model model = read_part(path);
  EXPECT_TRUE(model.provenance().id_mark.empty());
  EXPECT_EQ(ids(model, 2), std::set<int>{0});
}

}  // namespace
}  // namespace octet::test
