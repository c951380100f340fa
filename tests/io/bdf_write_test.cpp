// SPDX-License-Identifier: BSD-3-Clause
// What a reader of Nastran's bulk data finds in its fixed fields.
#include "io/bdf_write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

/// An entry with the lines that continue it: its name without the star, and its fields without blanks.
struct Entry {
  std::string name;
  std::vector<std::string> fields;
  int number(std::size_t k) const { return std::stoi(fields.at(k)); }
};

struct BulkData {
  std::vector<Entry> entries;
  std::vector<std::string> comments;
  std::vector<Entry> of(const std::string& name) const {
    std::vector<Entry> found;
    for (const Entry& e : entries)
      if (e.name == name) found.push_back(e);
    return found;
  }
  std::map<int, Vec3> nodes() const {
    std::map<int, Vec3> places;
    for (const Entry& e : of("GRID")) {
      EXPECT_EQ(e.fields.size(), 5u);
      EXPECT_EQ(e.fields[1], "");
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        const std::string& field = e.fields[static_cast<std::size_t>(i) + 2];
        EXPECT_NE(field.find('.'), std::string::npos) << field;
        p[i] = std::stod(field);
      }
      EXPECT_TRUE(places.emplace(e.number(0), p).second) << e.number(0);
    }
    return places;
  }
  /// The nodes of the set of this number.
  std::vector<int> set(int number) const {
    for (const Entry& e : of("SET1")) {
      if (e.number(0) != number) continue;
      std::vector<int> nodes;
      for (std::size_t k = 1; k < e.fields.size(); ++k) nodes.push_back(e.number(k));
      return nodes;
    }
    return {};
  }
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

BulkData bulk_data(const Mesh& mesh, const ModelOutline& outline, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".bdf");
  write_mesh(path, mesh, outline, mesh_format(path, ""), {.scale = scale});
  std::ifstream in(path);
  BulkData data;
  bool continued = false;
  for (std::string line; std::getline(in, line);) {
    if (line.front() == '$') {
      data.comments.push_back(line.substr(2));
      continue;
    }
    EXPECT_LE(line.size(), 73u) << line;
    const std::string head = trimmed(line.substr(0, 8));
    const std::size_t width = head.find('*') == std::string::npos ? 8 : 16;
    const bool continues = head == "+" || head == "*";
    EXPECT_EQ(continues, continued) << line;
    continued = line.size() == 73u;
    if (continued) {
      EXPECT_EQ(line.back(), width == 16 ? '*' : '+');
      line.pop_back();
    }
    if (!continues) data.entries.push_back({head.substr(0, head.find('*')), {}});
    for (std::size_t k = 8; k < line.size(); k += width)
      data.entries.back().fields.push_back(trimmed(line.substr(k, width)));
  }
  std::filesystem::remove(path);
  return data;
}

TEST(BdfWrite, NodesAndElementsAreTheMeshsInItsOrder) {
  const Mesh mesh = test::plain_box_mesh(2);
  const BulkData data = bulk_data(mesh, {}, 0.5);
  const auto nodes = data.nodes();
  ASSERT_EQ(nodes.size(), mesh.points.size());
  for (const auto& [number, p] : nodes)
    EXPECT_LT((p - 0.5 * mesh.points[static_cast<std::size_t>(number) - 1]).norm(), 1e-12);
  const auto elements = data.of("CTETRA");
  ASSERT_EQ(elements.size(), mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    ASSERT_EQ(elements[t].fields.size(), 6u);
    EXPECT_EQ(elements[t].number(0), static_cast<int>(t) + 1);
    EXPECT_EQ(elements[t].number(1), 1);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(elements[t].number(k + 2), static_cast<int>(mesh.tets[t][k]) + 1);
  }
  const auto properties = data.of("PSOLID");
  ASSERT_EQ(properties.size(), 1u);
  EXPECT_TRUE(properties[0].number(0) == 1 && properties[0].number(1) == 1);
}

/// The last six nodes of a CTETRA: which two corners each is between. [Nastran, "CTETRA"]
TEST(BdfWrite, MiddlesStandBetweenTheirCorners) {
  constexpr std::size_t kBetween[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  const BulkData data = bulk_data(mesh, {});
  const auto nodes = data.nodes();
  ASSERT_EQ(nodes.size(), mesh.points.size() + mesh.mid.points.size());
  const auto elements = data.of("CTETRA");
  ASSERT_EQ(elements.size(), mesh.tets.size());
  for (const Entry& e : elements) {
    ASSERT_EQ(e.fields.size(), 12u);
    const auto at = [&](std::size_t k) { return nodes.at(e.number(k + 2)); };
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_LT((at(4 + k) - 0.5 * (at(kBetween[k][0]) + at(kBetween[k][1]))).norm(), 1e-12);
  }
  EXPECT_EQ(data.set(1).size(), 25u);  // of a grid of 2 x 2 squares cut in two: 9 corners and 16 middles
}

TEST(BdfWrite, PressureIsOnTheSidesThatLieOnTheFace) {
  const Mesh mesh = test::plain_box_mesh(3);
  const BulkData data = bulk_data(mesh, {});
  std::map<int, int> of_face;
  for (const Entry& e : data.of("PLOAD4")) {
    ASSERT_EQ(e.fields.size(), 8u);
    EXPECT_EQ(std::stod(e.fields[2]), 1.0);
    for (const std::size_t k : {3u, 4u, 5u}) EXPECT_EQ(e.fields[k], "");  // the same at all corners
    const auto& tet = mesh.tets[static_cast<std::size_t>(e.number(1)) - 1];
    Vec3 middle = Vec3::Zero();
    bool has_corner = false;
    for (const Mesh::Index v : tet) {
      if (static_cast<int>(v) + 1 == e.number(7)) continue;
      has_corner = has_corner || static_cast<int>(v) + 1 == e.number(6);
      middle += mesh.points[v] / 3.0;
    }
    EXPECT_TRUE(has_corner);
    EXPECT_EQ(test::plain_box(Vec3(3.0, 2.0, 1.0)).on(middle), model_face(e.number(0)));
    ++of_face[e.number(0)];
  }
  for (int face = 1; face <= 6; ++face) EXPECT_EQ(of_face[face], 18);
}

TEST(BdfWrite, EachFaceEdgeAndVertexIsASetOfItsNodes) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.entities[2][1].name = "bore \"A\"";
  outline.entities[3][0].name = "body";
  const Mesh mesh = test::plain_box_mesh(3);
  const BulkData data = bulk_data(mesh, outline);
  EXPECT_EQ(data.of("SET1").size(), 6u + 12u + 8u);
  for (int face = 1; face <= 6; ++face) EXPECT_EQ(data.set(face).size(), 16u);
  for (int edge = 1; edge <= 12; ++edge) EXPECT_EQ(data.set(6 + edge).size(), 4u);
  for (int vertex = 1; vertex <= 8; ++vertex) {
    const auto nodes = data.set(6 + 12 + vertex);
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_EQ(mesh.point_on[static_cast<std::size_t>(nodes[0]) - 1], model_vertex(vertex));
  }
  for (const char* text :
       {"Solid1, body: its elements", "Face2, bore__A_: its nodes, and a load set of unit pressure",
        "Face1: its nodes, and a load set of unit pressure", "Edge1: its nodes"})
    EXPECT_NE(std::find(data.comments.begin(), data.comments.end(), text), data.comments.end()) << text;
}

TEST(BdfWrite, AGroupHasTheNodesAndThePressureOfAllItsFaces) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.groups = {{"wet", 2, {1, 3}}, {"all", 3, {1}}};
  const BulkData data = bulk_data(test::plain_box_mesh(3), outline);
  constexpr int kNumber = 6 + 12 + 8 + 1;  // behind those of faces, edges and vertices
  EXPECT_EQ(data.of("SET1").size(), static_cast<std::size_t>(kNumber)) << "a group of solids has none";
  std::set<int> nodes;
  for (const int face : {1, 3})
    for (const int node : data.set(face)) nodes.insert(node);
  EXPECT_EQ(data.set(kNumber), std::vector<int>(nodes.begin(), nodes.end()));
  int pressed = 0;
  for (const Entry& e : data.of("PLOAD4")) pressed += e.number(0) == kNumber ? 1 : 0;
  EXPECT_EQ(pressed, 2 * 18);
}

TEST(BdfWrite, WideFieldsHaveSixteenCharactersAndAPoint) {
  for (const double x : {0.0, -0.0, 1.0, -1.0, 9.99999999999999999, 999.9999999999999, -99999.99999999999,
                         1e-3, 9.999999999999e-4, -1.23456789012345e-7, 3.3e-88, 4e-300, 123456.789012345,
                         -1.5e8, 1e9, 7.7777777777e12}) {
    const std::string text = wide_field(x);
    ASSERT_EQ(text.size(), 16u) << text;
    EXPECT_EQ(text.front(), ' ') << text;
    EXPECT_NE(text.find('.'), std::string::npos) << text;
    EXPECT_NEAR(std::stod(text), x, 1e-9 * std::fabs(x) + 1e-90) << text;
  }
  EXPECT_NEAR(std::stod(wide_field(-123.456789012345)), -123.456789012345, 1e-10);
}

}  // namespace
}  // namespace octet
