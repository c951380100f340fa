// SPDX-License-Identifier: BSD-3-Clause
// What a reader of Medit's format finds behind its keywords, as text and in binary.
#include "io/medit_write.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

struct MeditItems {
  std::vector<Vec3> points;
  std::map<std::string, std::vector<std::vector<int>>> integers;  ///< per keyword, reference last
};

/// Integers of an item.
const std::map<std::string, std::pair<int, std::size_t>> kKeywords{
    {"Vertices", {4, 1}},   {"Corners", {13, 1}}, {"Edges", {5, 3}},        {"Triangles", {6, 4}},
    {"Tetrahedra", {8, 5}}, {"EdgesP2", {25, 4}}, {"TrianglesP2", {24, 7}}, {"TetrahedraP2", {30, 11}}};

std::string written(const Mesh& mesh, const ModelOutline& outline, const char* suffix, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + suffix);
  write_mesh(path, mesh, outline, mesh_format(path, ""), {.scale = scale});
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  return bytes;
}

/// By the grammar: keywords and numbers between blanks, # until a line's end.
MeditItems read_text(const std::string& text) {
  std::string bare, line;
  for (std::istringstream lines(text); std::getline(lines, line);)
    bare += line.substr(0, line.find('#')) + "\n";
  std::istringstream in(bare);
  MeditItems found;
  std::string keyword;
  int version = 0, dimension = 0;
  in >> keyword >> version;
  EXPECT_EQ(keyword, "MeshVersionFormatted");
  EXPECT_EQ(version, 2);
  in >> keyword >> dimension;
  EXPECT_EQ(keyword, "Dimension");
  EXPECT_EQ(dimension, 3);
  while (in >> keyword && keyword != "End") {
    const std::size_t width = kKeywords.at(keyword).second;
    std::size_t n = 0;
    in >> n;
    for (std::size_t i = 0; i < n; ++i) {
      if (keyword == "Vertices") {
        double x = 0.0, y = 0.0, z = 0.0;
        in >> x >> y >> z;
        found.points.emplace_back(x, y, z);
      }
      std::vector<int> item(width);
      for (int& k : item) in >> k;
      found.integers[keyword].push_back(item);
    }
    EXPECT_TRUE(in) << keyword;
  }
  EXPECT_EQ(keyword, "End");
  return found;
}

/// By the chain of places that keywords give; those of version 3 have eight bytes.
class BinaryReader {
 public:
  explicit BinaryReader(const std::string& bytes, int version = 2) : bytes_(bytes), wide_(version == 3) {
    EXPECT_EQ(take<std::int32_t>(), 1);
    EXPECT_EQ(take<std::int32_t>(), version);
    EXPECT_EQ(take<std::int32_t>(), 3);
    std::size_t next = take_place();
    EXPECT_EQ(take<std::int32_t>(), 3);
    while (next != 0) {
      EXPECT_EQ(at_, next);
      at_ = next;
      const int code = take<std::int32_t>();
      next = take_place();
      if (code == 54) break;
      read_items(code);
    }
    EXPECT_EQ(at_, bytes_.size());
  }
  MeditItems found;

 private:
  template <class T>
  T take() {
    T value{};
    if (at_ + sizeof value > bytes_.size()) throw std::runtime_error("the file ends too soon");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  std::size_t take_place() {
    return wide_ ? static_cast<std::size_t>(take<std::int64_t>())
                 : static_cast<std::size_t>(take<std::int32_t>());
  }

  void read_items(int code) {
    for (const auto& [keyword, known] : kKeywords) {
      if (known.first != code) continue;
      const int n = take<std::int32_t>();
      for (int i = 0; i < n; ++i) {
        if (keyword == "Vertices") {
          const double x = take<double>(), y = take<double>(), z = take<double>();
          found.points.emplace_back(x, y, z);
        }
        std::vector<int> item(known.second);
        for (int& k : item) k = take<std::int32_t>();
        found.integers[keyword].push_back(item);
      }
      return;
    }
    ADD_FAILURE() << "keyword " << code;
  }

  const std::string& bytes_;
  bool wide_;
  std::size_t at_ = 0;
};

template <class Elements>
std::vector<std::vector<int>> numbered(const Elements& elements, const std::vector<std::int32_t>& tags) {
  std::vector<std::vector<int>> rows;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    rows.emplace_back();
    for (const Mesh::Index v : elements[i]) rows.back().push_back(static_cast<int>(v) + 1);
    rows.back().push_back(tags[i]);
  }
  return rows;
}

TEST(MeditWrite, TextAndBinaryHaveTheMeshInItsOrder) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  const std::string text = written(mesh, {}, ".mesh", 0.1), binary = written(mesh, {}, ".meshb", 0.1);
  for (const MeditItems& found : {read_text(text), BinaryReader(binary).found}) {
    ASSERT_EQ(found.points.size(), mesh.points.size());
    std::vector<int> corners;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_EQ(found.points[v], Vec3(mesh.points[v] * 0.1));
      EXPECT_EQ(found.integers.at("Vertices")[v][0], mesh.point_on[v].tag);
      if (mesh.point_on[v].dim == 0) corners.push_back(static_cast<int>(v) + 1);
    }
    ASSERT_EQ(corners.size(), 8u);
    for (std::size_t i = 0; i < corners.size(); ++i)
      EXPECT_EQ(found.integers.at("Corners").at(i)[0], corners[i]);
    EXPECT_EQ(found.integers.at("Edges"), numbered(mesh.edges, mesh.edge_on));
    EXPECT_EQ(found.integers.at("Triangles"), numbered(mesh.triangles, mesh.triangle_on));
    EXPECT_EQ(found.integers.at("Tetrahedra"), numbered(mesh.tets, mesh.tet_in));
    EXPECT_EQ(found.integers.size(), 5u);
  }
}

/// A file that is larger than places of four bytes reach: here one of more than a byte.
TEST(MeditWrite, LargeFilesAreOfVersionThree) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  const auto path = std::filesystem::temp_directory_path() / "octet_LargeFilesAreOfVersionThree.meshb";
  OutputFile file(path);
  write_medit(file, mesh, {}, Encoding::kBinary, 1.0, 1);
  file.commit();
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  const MeditItems found = BinaryReader(bytes, 3).found;
  EXPECT_EQ(found.points.size(), mesh.points.size());
  EXPECT_EQ(found.integers.at("Tetrahedra"), numbered(mesh.tets, mesh.tet_in));
}

/// Of edges 0-1, 1-2, 2-0, and of tetrahedra 0-3, 1-3, 2-3.
TEST(MeditWrite, MiddlesFollowTheCorners) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  constexpr std::size_t kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  const std::string text = written(mesh, {}, ".mesh"), binary = written(mesh, {}, ".meshb");
  for (const MeditItems& found : {read_text(text), BinaryReader(binary).found}) {
    EXPECT_EQ(found.points.size(), mesh.points.size() + mesh.mid.points.size());
    EXPECT_EQ(found.integers.at("EdgesP2").size(), mesh.edges.size());
    EXPECT_EQ(found.integers.at("TrianglesP2").size(), mesh.triangles.size());
    EXPECT_EQ(found.integers.at("TetrahedraP2").size(), mesh.tets.size());
    for (const auto& [keyword, corners, middles] :
         {std::tuple("EdgesP2", 2, 1), std::tuple("TrianglesP2", 3, 3), std::tuple("TetrahedraP2", 4, 6)})
      for (const std::vector<int>& item : found.integers.at(keyword)) {
        const auto at = [&](std::size_t k) { return found.points.at(static_cast<std::size_t>(item[k]) - 1); };
        for (int m = 0; m < middles; ++m) {
          const auto& [a, b] = kEnds[m];
          EXPECT_LT((at(static_cast<std::size_t>(corners + m)) - 0.5 * (at(a) + at(b))).norm(), 1e-14)
              << keyword << " " << m;
        }
      }
  }
}

TEST(MeditWrite, CommentsTellTheNamesThatTheCadGives) {
  const std::string text =
      written(test::plain_box_mesh(1), test::plain_box_outline(Vec3(3.0, 2.0, 1.0), true), ".mesh");
  EXPECT_NE(text.find("\n# Solid1: body\n"), std::string::npos);
  EXPECT_NE(text.find("\n# Face3: bore"), std::string::npos);
  EXPECT_EQ(text.find("# Face1:"), std::string::npos);
  EXPECT_EQ(read_text(text).points.size(), 8u);
}

}  // namespace
}  // namespace octet
