// SPDX-License-Identifier: BSD-3-Clause
// What a reader of Exodus files finds by the names that it looks for.
#include "io/exodus_write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "io/netcdf_classic.h"
#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

/// A file in netCDF's classic forms, read by the grammar of its specification.
class NetcdfFile {
 public:
  struct Variable {
    std::vector<std::string> dimensions;
    std::map<std::string, std::string> texts;  ///< attributes
    std::uint32_t type = 0;
    std::uint64_t bytes = 0, begin = 0;
  };

  explicit NetcdfFile(std::string bytes) : bytes_(std::move(bytes)) {
    EXPECT_EQ(bytes_.substr(0, 3), "CDF");
    wide_ = bytes_.at(3) == '\5';
    EXPECT_TRUE(wide_ || bytes_.at(3) == '\2');
    at_ = 4;
    EXPECT_EQ(count(), 0u);
    const std::uint64_t n = list(10);
    for (std::uint64_t i = 0; i < n; ++i) {
      names_.push_back(text());
      dimensions[names_.back()] = count();
    }
    texts = attributes();
    const std::uint64_t variables_here = list(11);
    for (std::uint64_t i = 0; i < variables_here; ++i) {
      const std::string name = text();
      Variable& v = variables[name];
      for (std::uint64_t k = count(); k > 0; --k) v.dimensions.push_back(names_.at(count()));
      v.texts = attributes();
      v.type = static_cast<std::uint32_t>(number(4));
      v.bytes = count();
      v.begin = number(8);
    }
    header_ends = at_;
  }

  std::vector<int> ints(const std::string& name) {
    EXPECT_EQ(variables.at(name).type, 4u) << name;
    std::vector<int> values;
    at_ = variables.at(name).begin;
    for (std::uint64_t i = 0; i < length(name); ++i) values.push_back(static_cast<int>(number(4)));
    return values;
  }
  std::vector<double> doubles(const std::string& name) {
    EXPECT_EQ(variables.at(name).type, 6u) << name;
    std::vector<double> values;
    at_ = variables.at(name).begin;
    for (std::uint64_t i = 0; i < length(name); ++i) values.push_back(std::bit_cast<double>(number(8)));
    return values;
  }
  std::vector<std::string> words(const std::string& name) {
    EXPECT_EQ(variables.at(name).type, 2u) << name;
    const Variable& v = variables.at(name);
    const std::uint64_t width = dimensions.at(v.dimensions.at(1));
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < length(name); i += width)
      all.emplace_back(bytes_.substr(v.begin + i, width).c_str());
    return all;
  }
  /// The values that the variable's dimensions give it.
  std::uint64_t length(const std::string& name) const {
    std::uint64_t n = 1;
    for (const std::string& dimension : variables.at(name).dimensions) n *= dimensions.at(dimension);
    return n;
  }
  bool wide() const { return wide_; }
  std::uint64_t size() const { return bytes_.size(); }

  std::map<std::string, std::uint64_t> dimensions;
  std::map<std::string, std::string> texts;
  std::map<std::string, Variable> variables;
  std::uint64_t header_ends = 0;

 private:
  std::uint64_t number(int width) {
    std::uint64_t value = 0;
    for (int i = 0; i < width; ++i) value = value << 8 | static_cast<unsigned char>(bytes_.at(at_++));
    return value;
  }
  std::uint64_t count() { return number(wide_ ? 8 : 4); }
  std::uint64_t list(std::uint64_t kind) {
    const std::uint64_t tag = number(4), n = count();
    EXPECT_EQ(tag, n == 0 ? 0 : kind);
    return n;
  }
  std::string text() {
    const std::uint64_t n = count();
    const std::string value = bytes_.substr(at_, n);
    at_ += (n + 3) / 4 * 4;
    return value;
  }
  std::map<std::string, std::string> attributes() {
    std::map<std::string, std::string> found;
    const std::uint64_t n = list(12);
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::string name = text();
      const std::uint64_t type = number(4);
      if (type == 2) {
        found[name] = text();
      } else {
        EXPECT_TRUE(type == 4 || type == 5);
        EXPECT_EQ(count(), 1u);
        number(4);
      }
    }
    return found;
  }

  std::string bytes_;
  std::uint64_t at_ = 0;
  bool wide_ = false;
  std::vector<std::string> names_;
};

std::filesystem::path file_of_test() {
  return std::filesystem::temp_directory_path() /
         (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".exo");
}

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  in.close();
  std::filesystem::remove(path);
  return bytes;
}

NetcdfFile exodus(const Mesh& mesh, const ModelOutline& outline, double scale = 1.0) {
  write_mesh(file_of_test(), mesh, outline, mesh_format(file_of_test(), ""), {.scale = scale});
  return NetcdfFile(content(file_of_test()));
}

/// Nodes of the sides of a tetrahedron in the manual's numbers, outwards.
constexpr int kSide[4][3] = {{1, 2, 4}, {2, 3, 4}, {1, 4, 3}, {1, 3, 2}};

TEST(ExodusWrite, NodesAndElementsAreTheMeshsInItsOrder) {
  const Mesh mesh = test::plain_box_mesh(2);
  NetcdfFile file = exodus(mesh, {}, 0.5);
  EXPECT_FALSE(file.wide());
  EXPECT_EQ(file.dimensions.at("num_dim"), 3u);
  EXPECT_EQ(file.dimensions.at("time_step"), 0u);
  ASSERT_EQ(file.dimensions.at("num_nodes"), mesh.points.size());
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> along = file.doubles(std::string("coord") + "xyz"[axis]);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) EXPECT_EQ(along[v], 0.5 * mesh.points[v][axis]);
  }
  ASSERT_EQ(file.dimensions.at("num_el_blk"), 1u);
  EXPECT_EQ(file.ints("eb_prop1"), std::vector<int>{1});
  EXPECT_EQ(file.variables.at("connect1").texts.at("elem_type"), "TETRA");
  const std::vector<int> nodes = file.ints("connect1");
  ASSERT_EQ(nodes.size(), 4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(nodes[4 * t + k], static_cast<int>(mesh.tets[t][k]) + 1);
  EXPECT_FALSE(file.variables.contains("elem_num_map"));
  EXPECT_EQ(file.variables.at("time_whole").begin, file.size());
}

TEST(ExodusWrite, MiddlesStandBetweenTheirCornersInTheManualsOrder) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  NetcdfFile file = exodus(mesh, {});
  EXPECT_EQ(file.variables.at("connect1").texts.at("elem_type"), "TETRA10");
  EXPECT_EQ(file.dimensions.at("num_nodes"), mesh.points.size() + mesh.mid.points.size());
  const std::vector<int> nodes = file.ints("connect1");
  ASSERT_EQ(nodes.size(), 10 * mesh.tets.size());
  std::vector<double> along[3];
  for (int axis = 0; axis < 3; ++axis) along[axis] = file.doubles(std::string("coord") + "xyz"[axis]);
  const auto at = [&](int node) {
    const auto v = static_cast<std::size_t>(node) - 1;
    return Vec3(along[0][v], along[1][v], along[2][v]);
  };
  constexpr int kBetween[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 6; ++k) {
      const int* of = &nodes[10 * t];
      EXPECT_LT((at(of[4 + k]) - 0.5 * (at(of[kBetween[k][0]]) + at(of[kBetween[k][1]]))).norm(), 1e-12);
    }
  const std::vector<std::string> names = file.words("ns_names");
  const auto face = std::find(names.begin(), names.end(), "Face1") - names.begin();
  EXPECT_EQ(file.ints("node_ns" + std::to_string(face + 1)).size(), 25u);  // 9 corners and 16 middles
}

TEST(ExodusWrite, SideSetsAreTheTrianglesOfTheirFacesInTheManualsNumbers) {
  const Mesh mesh = test::halved_box_mesh(2, {2, 2, 2});
  NetcdfFile file = exodus(mesh, {});
  ASSERT_EQ(file.ints("eb_prop1"), (std::vector<int>{1, 2}));
  // Elements as the file numbers them: block by block.
  std::vector<std::vector<int>> elements;
  std::vector<int> block_of;
  for (int block = 1; block <= 2; ++block) {
    const std::vector<int> nodes = file.ints("connect" + std::to_string(block));
    for (std::size_t i = 0; i < nodes.size(); i += 4) {
      elements.emplace_back(nodes.begin() + static_cast<std::ptrdiff_t>(i),
                            nodes.begin() + static_cast<std::ptrdiff_t>(i) + 4);
      block_of.push_back(block);
    }
  }
  const std::vector<int> own = file.ints("elem_num_map");
  ASSERT_EQ(own.size(), mesh.tets.size());
  for (std::size_t e = 0; e < own.size(); ++e) {
    const auto t = static_cast<std::size_t>(own[e]) - 1;
    EXPECT_EQ(mesh.tet_in[t], block_of[e]);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(elements[e][k], static_cast<int>(mesh.tets[t][k]) + 1);
  }
  ASSERT_EQ(file.ints("ss_prop1"), (std::vector<int>{1, 2, 3, 4, 5, 6, 7}));
  for (int face = 1; face <= 7; ++face) {
    const std::vector<int> of = file.ints("elem_ss" + std::to_string(face));
    const std::vector<int> sides = file.ints("side_ss" + std::to_string(face));
    ASSERT_EQ(of.size(), sides.size());
    std::vector<std::array<Mesh::Index, 3>> wanted, found;
    const auto turned = [](std::array<Mesh::Index, 3> v) {  // least node first
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      return v;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (mesh.triangle_on[i] == face) wanted.push_back(turned(mesh.triangles[i]));
    for (std::size_t i = 0; i < of.size(); ++i) {
      const std::vector<int>& element = elements.at(static_cast<std::size_t>(of[i]) - 1);
      std::array<Mesh::Index, 3> v{};
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = static_cast<Mesh::Index>(element[static_cast<std::size_t>(kSide[sides[i] - 1][k]) - 1]) - 1;
      found.push_back(turned(v));
      EXPECT_TRUE(face != 7 || block_of[static_cast<std::size_t>(of[i]) - 1] == 2);
    }
    std::sort(wanted.begin(), wanted.end());
    std::sort(found.begin(), found.end());
    EXPECT_FALSE(wanted.empty());
    EXPECT_EQ(found, wanted) << "face " << face;  // all of them outwards, as the triangles are here
  }
}

TEST(ExodusWrite, EveryEntityIsASetByItsNameAndANumberOfItsOwn) {
  const Vec3 size(3.0, 2.0, 1.0);
  const Mesh mesh = test::plain_box_mesh(2);
  ModelOutline outline = test::plain_box_outline(size, true);
  outline.entities[1][0].name = "an edge with a name of more than 32 characters";
  NetcdfFile file = exodus(mesh, outline);
  EXPECT_EQ(file.words("eb_names"), std::vector<std::string>{"body"});
  EXPECT_EQ(file.words("ss_names"),
            (std::vector<std::string>{"Face1", "Face2", "bore__A_", "Face4", "Face5", "Face6"}));
  const std::vector<std::string> names = file.words("ns_names");
  const std::vector<int> numbers = file.ints("ns_prop1");
  ASSERT_EQ(names.size(), 6u + 12u + 8u);
  EXPECT_EQ(names[2], "bore__A_");
  EXPECT_EQ(names[6], "an_edge_with_a_name_of_more_than");
  EXPECT_EQ(names[25], "Vertex8");
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(numbers[i], static_cast<int>(i) + 1);
    const ModelRef entity = i < 6    ? model_face(static_cast<int>(i) + 1)
                            : i < 18 ? ModelRef{1, static_cast<int>(i) - 5}
                                     : ModelRef{0, static_cast<int>(i) - 17};
    for (const int node : file.ints("node_ns" + std::to_string(i + 1))) {
      const ModelRef on = mesh.point_on[static_cast<std::size_t>(node) - 1];
      EXPECT_TRUE(on == entity || on.dim < entity.dim) << names[i];
    }
  }
}

TEST(ExodusWrite, AGroupHasTheSidesAndNodesOfAllItsFaces) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.groups = {{"wet", 2, {1, 3}}};
  NetcdfFile file = exodus(test::plain_box_mesh(2), outline);
  EXPECT_EQ(file.words("ss_names").back(), "wet");
  EXPECT_EQ(file.ints("ss_prop1").back(), 7);
  EXPECT_EQ(file.ints("elem_ss7").size(), file.ints("elem_ss1").size() + file.ints("elem_ss3").size());
  EXPECT_EQ(file.words("ns_names").back(), "wet");
  EXPECT_EQ(file.ints("ns_prop1").back(), 6 + 12 + 8 + 1);
  EXPECT_FALSE(file.ints("node_ns27").empty());
}

TEST(ExodusWrite, AMeshWithoutElementsIsAFileAllTheSame) {
  NetcdfFile file = exodus({}, {});
  EXPECT_FALSE(file.dimensions.contains("num_nodes") || file.dimensions.contains("num_elem"));
  EXPECT_EQ(file.header_ends, file.size());
}

TEST(NetcdfClassic, LengthsHaveSixtyFourBitsWhereAVariableIsTooLargeForLess) {
  for (const std::uint64_t length : {std::uint64_t{1} << 28, std::uint64_t{1} << 29}) {
    NetcdfClassic netcdf;
    const auto many = netcdf.dimension("many", length);
    const auto some = netcdf.dimension("some", 3);
    // The writers put out nothing: of the file there is the header alone.
    netcdf.variable("large", NetcdfClassic::Type::kDouble, {many}, [](OutputFile&) {});
    netcdf.variable("odd", NetcdfClassic::Type::kChar, {some}, [](OutputFile&) {}, {{"unit", "mm"}});
    OutputFile out(file_of_test());
    netcdf.write(out);
    out.commit();
    const NetcdfFile file(content(file_of_test()));
    EXPECT_EQ(file.wide(), length > std::uint64_t{1} << 28);
    EXPECT_EQ(file.dimensions.at("many"), length);
    EXPECT_EQ(file.variables.at("large").bytes, 8 * length);
    EXPECT_EQ(file.variables.at("large").begin, file.header_ends);
    EXPECT_EQ(file.variables.at("odd").bytes, 4u);
    EXPECT_EQ(file.variables.at("odd").begin, file.header_ends + 8 * length);
    EXPECT_EQ(file.variables.at("odd").texts.at("unit"), "mm");
  }
}

}  // namespace
}  // namespace octet
