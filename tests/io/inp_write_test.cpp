// SPDX-License-Identifier: BSD-3-Clause
// What a solver finds in an .inp file: elements, sets and surfaces, read back word by word.
#include "io/inp_write.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

/// A deck as blocks: the keyword's line, and the numbers of each line below it, or its one word where that is
/// the name of a set. A side S3 is read as 3.
struct Block {
  std::string head;
  std::vector<std::vector<double>> lines;
  std::vector<std::string> sets;
};

std::vector<Block> deck_of(const Mesh& mesh, const ModelOutline& outline, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".inp");
  write_mesh(path, mesh, outline, MeshFormat::kInp, {.scale = scale});
  std::ifstream in(path);
  std::vector<Block> deck;
  for (std::string line; std::getline(in, line);) {
    if (line.front() == '*') {
      deck.push_back({line, {}, {}});
      continue;
    }
    if (deck.back().head == "*HEADING") continue;
    if (std::isalpha(static_cast<unsigned char>(line.front())) != 0) {
      deck.back().sets.push_back(line);
      continue;
    }
    std::vector<double>& numbers = deck.back().lines.emplace_back();
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');) {
      const std::size_t start = word.find_first_not_of(' ');
      EXPECT_LE(word.size() - start, 20u) << word;
      numbers.push_back(std::stod(word.substr(word[start] == 'S' ? start + 1 : start)));
    }
  }
  std::filesystem::remove(path);
  return deck;
}

const Block* block(const std::vector<Block>& deck, const std::string& head) {
  for (const Block& b : deck)
    if (b.head == head) return &b;
  return nullptr;
}

/// Corners of the sides of a C3D4 as the manuals number them, from 1; by the right-hand rule they point
/// inwards.
constexpr int kSide[4][3] = {{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}};

TEST(InpWrite, ElementsAndNodesAreTheMeshsInItsOrder) {
  const Mesh mesh = test::plain_box_mesh(2);
  const auto deck = deck_of(mesh, {}, 0.5);
  const Block* nodes = block(deck, "*NODE, NSET=Nall");
  ASSERT_TRUE(nodes != nullptr && nodes->lines.size() == mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    EXPECT_EQ(nodes->lines[v][0], static_cast<double>(v + 1));
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(nodes->lines[v][static_cast<std::size_t>(i) + 1], 0.5 * mesh.points[v][i], 1e-12);
  }
  const Block* elements = block(deck, "*ELEMENT, TYPE=C3D4, ELSET=Solid1");
  ASSERT_TRUE(elements != nullptr && elements->lines.size() == mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(elements->lines[t][k + 1], static_cast<double>(mesh.tets[t][k] + 1));
}

/// The last six nodes of a C3D10: which two corners each is between. [CalculiX, "Ten-node tetrahedral
/// element"]
TEST(InpWrite, ElementsOfSecondOrderHaveTheirNodesWhereTheManualsHaveThem) {
  constexpr std::size_t kBetween[6][2] = {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}};
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  const auto deck = deck_of(mesh, {});
  const Block* nodes = block(deck, "*NODE, NSET=Nall");
  ASSERT_TRUE(nodes != nullptr && nodes->lines.size() == mesh.points.size() + mesh.mid.points.size());
  const auto place = [&](double node) {
    const auto& line = nodes->lines[static_cast<std::size_t>(node) - 1];
    return Vec3(line[1], line[2], line[3]);
  };
  const Block* elements = block(deck, "*ELEMENT, TYPE=C3D10, ELSET=Solid1");
  ASSERT_TRUE(elements != nullptr && elements->lines.size() == mesh.tets.size());
  for (const auto& line : elements->lines) {
    ASSERT_EQ(line.size(), 11u);
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_LT(
          (place(line[5 + k]) - 0.5 * (place(line[kBetween[k][0]]) + place(line[kBetween[k][1]]))).norm(),
          1e-11);
  }
  const Block* face = block(deck, "*NSET, NSET=Face1");
  ASSERT_TRUE(face != nullptr);
  std::size_t in_set = 0;
  for (const auto& line : face->lines) in_set += line.size();
  EXPECT_EQ(in_set, 25u);  // of a grid of 2 x 2 squares cut in two: 9 corners and 16 middles
}

TEST(InpWrite, SurfacesAreTheSidesThatLieOnTheirFaceInTheManualsNumbers) {
  const Mesh mesh = test::plain_box_mesh(3);
  const auto deck = deck_of(mesh, {});
  for (int face = 1; face <= 6; ++face) {
    const std::string name = "Face" + std::to_string(face);
    const Block* surface = block(deck, "*SURFACE, NAME=" + name + ", TYPE=ELEMENT");
    const Block* set = block(deck, "*NSET, NSET=" + name);
    ASSERT_TRUE(surface != nullptr && set != nullptr);
    EXPECT_EQ(surface->lines.size(), 18u);
    std::size_t in_set = 0;
    for (const auto& line : set->lines) in_set += line.size();
    EXPECT_EQ(in_set, 16u);
    for (const auto& line : surface->lines) {
      const auto& tet = mesh.tets[static_cast<std::size_t>(line[0]) - 1];
      Vec3 p[3];
      for (int k = 0; k < 3; ++k) {
        const Mesh::Index v = tet[static_cast<std::size_t>(kSide[static_cast<int>(line[1]) - 1][k]) - 1];
        p[k] = mesh.points[v];
      }
      // A corner of the box lies on three faces; the middle of a side on one.
      const ModelRef on = test::plain_box(Vec3(3.0, 2.0, 1.0)).on((p[0] + p[1] + p[2]) / 3.0);
      EXPECT_EQ(on, model_face(face));
      EXPECT_GT((p[1] - p[0]).cross(p[2] - p[0]).dot(Vec3(1.5, 1.0, 0.5) - p[0]), 0.0);
    }
  }
}

TEST(InpWrite, SidesOfAnInterfaceLieInTheRegionItsNormalPointsOutOf) {
  const Mesh mesh = test::halved_box_mesh(1, {2, 1, 1});
  const auto deck = deck_of(mesh, {});
  const Block* surface = block(deck, "*SURFACE, NAME=Face7, TYPE=ELEMENT");
  ASSERT_TRUE(surface != nullptr);
  EXPECT_EQ(surface->lines.size(), 2u);
  for (const auto& line : surface->lines) EXPECT_EQ(mesh.tet_in[static_cast<std::size_t>(line[0]) - 1], 1);
  EXPECT_NE(block(deck, "*ELEMENT, TYPE=C3D4, ELSET=Solid2"), nullptr);
}

TEST(InpWrite, NamesAreMadeFitAndDifferInMoreThanCase) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.entities[2][0].name = "bore \"A\", 2";
  outline.entities[2][1].name = "BORE 'a'  2";
  outline.entities[2][2].name = "2nd";
  outline.entities[1][3].name = "Face4";
  const auto deck = deck_of(test::plain_box_mesh(1), outline);
  for (const char* name :
       {"bore__A___2_Face1", "BORE__a___2_Face2", "N2nd", "Face4", "Face4_Edge4", "Vertex8"})
    EXPECT_NE(block(deck, std::string("*NSET, NSET=") + name), nullptr) << name;
}

TEST(InpWrite, ANameOfSeveralFacesIsTheSetOfThemAllAndSoIsAGroup) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.entities[2][0].name = outline.entities[2][4].name = "seat";
  outline.entities[2][2].name = "fixed";
  outline.groups = {{"fixed", 2, {1, 3}}, {"far away", 2, {77}}};
  const Mesh mesh = test::plain_box_mesh(2);
  const auto deck = deck_of(mesh, outline);
  const auto lines = [&](const std::string& head) {
    const Block* found = block(deck, head);
    return found == nullptr ? 0u : found->lines.size();
  };
  using Names = std::vector<std::string>;
  const Block *seat = block(deck, "*NSET, NSET=seat"), *fixed = block(deck, "*NSET, NSET=fixed");
  ASSERT_TRUE(seat != nullptr && fixed != nullptr);
  EXPECT_EQ(seat->sets, (Names{"seat_Face1", "seat_Face5"}));
  EXPECT_EQ(fixed->sets, (Names{"seat_Face1", "fixed_Face3"}));
  EXPECT_EQ(lines("*SURFACE, NAME=fixed, TYPE=ELEMENT"), 2u * 8u);
  EXPECT_EQ(lines("*SURFACE, NAME=seat_Face5, TYPE=ELEMENT"), 8u);
  EXPECT_EQ(block(deck, "*NSET, NSET=far_away"), nullptr) << "of what has no elements";
}

TEST(InpWrite, NodesOfImagesStandInTheOrderOfTheirSources) {
  const Mesh mesh = test::plain_box_mesh(2);
  ModelOutline outline;
  outline.links.push_back({model_face(2), model_face(1), {}, {{5, 9}, {7, 0}, {8, 3}}});
  outline.links.push_back({model_edge(2), model_edge(1), {}, {{5, 9}}});
  const std::vector<Block> deck = deck_of(mesh, outline);
  const Block *image = block(deck, "*NSET, NSET=Face2_image, UNSORTED"),
              *source = block(deck, "*NSET, NSET=Face2_source, UNSORTED");
  ASSERT_TRUE(image != nullptr && source != nullptr);
  EXPECT_EQ(image->lines, (std::vector<std::vector<double>>{{6, 8, 9}}));
  EXPECT_EQ(source->lines, (std::vector<std::vector<double>>{{10, 1, 4}}));
  EXPECT_EQ(block(deck, "*NSET, NSET=Edge2_image, UNSORTED"), nullptr);
}

}  // namespace
}  // namespace octet
