// SPDX-License-Identifier: BSD-3-Clause
// What a reader of universal files finds: columns of ten and of twenty-five characters.
#include "io/unv_write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

struct Element {
  int kind = 0;
  std::vector<int> nodes;
};

struct Group {
  std::string name;
  std::vector<int> nodes, elements;
};

/// The file, read as its manual has it. [UNV, datasets 2411, 2412, 2467]
struct UniversalFile {
  std::map<int, Vec3> nodes;
  std::map<int, Element> elements;
  std::map<std::string, Group> groups;
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : in_(path) {
    while (next()) {
      EXPECT_EQ(line_, "    -1");
      EXPECT_TRUE(next());
      const int dataset = std::stoi(line_);
      while (next() && line_ != "    -1") {
        switch (dataset) {
          case 2411:
            read_node();
            break;
          case 2412:
            read_element();
            break;
          case 2467:
            read_group();
            break;
          default:
            ADD_FAILURE() << dataset;
        }
      }
    }
  }
  UniversalFile file;

 private:
  bool next() { return static_cast<bool>(std::getline(in_, line_)); }

  std::vector<int> numbers() const {
    EXPECT_EQ(line_.size() % 10, 0u) << line_;
    EXPECT_LE(line_.size(), 80u) << line_;
    std::vector<int> row;
    for (std::size_t k = 0; k < line_.size(); k += 10) row.push_back(std::stoi(line_.substr(k, 10)));
    return row;
  }

  void read_node() {
    const auto head = numbers();
    ASSERT_EQ(head.size(), 4u);
    ASSERT_TRUE(next() && line_.size() == 75u) << line_;
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      std::string number = line_.substr(static_cast<std::size_t>(25 * k), 25);
      ASSERT_EQ(number[21], 'D') << number;
      number[21] = 'E';
      p[k] = std::stod(number);
    }
    EXPECT_TRUE(file.nodes.emplace(head[0], p).second) << head[0];
  }

  void read_element() {
    const auto head = numbers();
    ASSERT_EQ(head.size(), 6u);
    Element e{head[1], {}};
    if (e.kind == 21 || e.kind == 24) {
      ASSERT_TRUE(next());
      EXPECT_EQ(numbers().size(), 3u);
    }
    while (static_cast<int>(e.nodes.size()) < head[5]) {
      ASSERT_TRUE(next());
      const auto row = numbers();
      e.nodes.insert(e.nodes.end(), row.begin(), row.end());
    }
    EXPECT_EQ(static_cast<int>(e.nodes.size()), head[5]);
    EXPECT_TRUE(file.elements.emplace(head[0], e).second) << head[0];
  }

  void read_group() {
    const auto head = numbers();
    ASSERT_EQ(head.size(), 8u);
    ASSERT_TRUE(next());
    Group g;
    g.name = line_;
    for (int left = head[7]; left > 0;) {
      ASSERT_TRUE(next());
      const auto row = numbers();
      for (std::size_t k = 0; k < row.size(); k += 4, --left) {
        ASSERT_TRUE(row[k] == 7 || row[k] == 8) << line_;
        (row[k] == 7 ? g.nodes : g.elements).push_back(row[k + 1]);
      }
    }
    EXPECT_TRUE(file.groups.emplace(g.name, g).second) << g.name;
  }

  std::ifstream in_;
  std::string line_;
};

UniversalFile file_of(const Mesh& mesh, const ModelOutline& outline, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".unv");
  write_mesh(path, mesh, outline, mesh_format(path, ""), {.scale = scale});
  Reader reader(path);
  std::filesystem::remove(path);
  return reader.file;
}

TEST(UnvWrite, NodesAndElementsAreTheMeshsInItsOrder) {
  const Mesh mesh = test::plain_box_mesh(2);
  const UniversalFile file = file_of(mesh, {}, 0.5);
  ASSERT_EQ(file.nodes.size(), mesh.points.size());
  for (const auto& [number, p] : file.nodes)
    EXPECT_EQ(p, Vec3(0.5 * mesh.points[static_cast<std::size_t>(number) - 1]));
  ASSERT_EQ(file.elements.size(), mesh.edges.size() + mesh.triangles.size() + mesh.tets.size());
  const auto same = [&](std::size_t label, int kind, const auto& element) {
    const Element& e = file.elements.at(static_cast<int>(label));
    EXPECT_EQ(e.kind, kind);
    ASSERT_EQ(e.nodes.size(), element.size());
    for (std::size_t k = 0; k < element.size(); ++k) EXPECT_EQ(e.nodes[k], static_cast<int>(element[k]) + 1);
  };
  std::size_t label = 0;
  for (const auto& e : mesh.edges) same(++label, 21, e);
  for (const auto& e : mesh.triangles) same(++label, 91, e);
  for (const auto& e : mesh.tets) same(++label, 111, e);
}

/// Along the border each middle is between its neighbours; of a tetrahedron the first six are its base, then
/// come the middles below the top, and the top.
TEST(UnvWrite, MiddlesStandBetweenTheirCorners) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  const UniversalFile file = file_of(mesh, {});
  std::map<int, std::vector<std::array<std::size_t, 3>>> between{
      {24, {{1, 0, 2}}},
      {92, {{1, 0, 2}, {3, 2, 4}, {5, 4, 0}}},
      {118, {{1, 0, 2}, {3, 2, 4}, {5, 4, 0}, {6, 0, 9}, {7, 2, 9}, {8, 4, 9}}}};
  std::map<int, std::size_t> seen;
  for (const auto& [label, e] : file.elements) {
    ASSERT_TRUE(between.count(e.kind) == 1) << e.kind;
    ++seen[e.kind];
    for (const auto& [middle, a, b] : between[e.kind])
      EXPECT_LT(
          (file.nodes.at(e.nodes[middle]) - 0.5 * (file.nodes.at(e.nodes[a]) + file.nodes.at(e.nodes[b])))
              .norm(),
          1e-14);
    if (e.kind != 118) continue;
    const Vec3 a = file.nodes.at(e.nodes[0]);
    const auto from_a = [&](std::size_t k) { return Vec3(file.nodes.at(e.nodes[k]) - a); };
    EXPECT_GT(from_a(2).cross(from_a(4)).dot(from_a(9)), 0.0);
  }
  EXPECT_EQ(seen[24], mesh.edges.size());
  EXPECT_EQ(seen[92], mesh.triangles.size());
  EXPECT_EQ(seen[118], mesh.tets.size());
}

TEST(UnvWrite, EachEntityIsAGroupByItsName) {
  const Mesh mesh = test::plain_box_mesh(2);
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.entities[2][1].name = "bore \"A\" " + std::string(60, 'x');
  const UniversalFile file = file_of(mesh, outline);
  EXPECT_EQ(file.groups.size(), 1u + 6u + 12u + 8u);
  EXPECT_EQ(file.groups.at("Solid1").elements.size(), mesh.tets.size());
  EXPECT_EQ(file.groups.at("bore__A__" + std::string(31, 'x')).elements.size(), 8u);
  const Group& face = file.groups.at("Face1");
  ASSERT_EQ(face.elements.size(), 8u);
  for (const int label : face.elements) {
    Vec3 middle = Vec3::Zero();
    for (const int v : file.elements.at(label).nodes) middle += file.nodes.at(v) / 3.0;
    EXPECT_EQ(test::plain_box(Vec3(3.0, 2.0, 1.0)).on(middle), model_face(1));
  }
  EXPECT_EQ(file.groups.at("Edge1").elements.size(), 2u);
  const Group& vertex = file.groups.at("Vertex1");
  ASSERT_TRUE(vertex.elements.empty() && vertex.nodes.size() == 1u);
  EXPECT_EQ(mesh.point_on[static_cast<std::size_t>(vertex.nodes[0]) - 1], model_vertex(1));
}

TEST(UnvWrite, ANameOfSeveralFacesIsTheGroupOfThemAll) {
  const Mesh mesh = test::plain_box_mesh(2);
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.entities[2][0].name = outline.entities[2][4].name = "seat";
  outline.groups = {{"corners", 0, {1, 8}}};
  const UniversalFile file = file_of(mesh, outline);
  std::vector<int> both = file.groups.at("seat_Face1").elements;
  for (const int label : file.groups.at("seat_Face5").elements) both.push_back(label);
  std::sort(both.begin(), both.end());
  EXPECT_EQ(file.groups.at("seat").elements, both);
  EXPECT_EQ(file.groups.at("corners").nodes.size(), 2u);
}

}  // namespace
}  // namespace octet
