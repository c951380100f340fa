// SPDX-License-Identifier: BSD-3-Clause
// What readers of MED and XDMF find in the files, read by HDF5's library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "io/hdf5_file.h"
#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/io/hdf5_reader.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

namespace fs = std::filesystem;
using test::Hdf5Reader;

const std::string kStep = "/ENS_MAA/mesh/-0000000000000000001-0000000000000000001";

/// A folder that is gone with the test.
class Hdf5Write : public ::testing::Test {
 protected:
  Hdf5Write()
      : folder_(fs::temp_directory_path() /
                (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~Hdf5Write() override { fs::remove_all(folder_); }

  fs::path write(const char* name, const Mesh& mesh, const ModelOutline& outline = {}, double scale = 1.0) {
    const fs::path path = folder_ / name;
    write_mesh(path, mesh, outline, mesh_format(path, ""), {.scale = scale});
    return path;
  }

  fs::path folder_;
};

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Elements of a kind, each with its nodes from 1: the array has all first nodes, then all second ones, ...
std::vector<std::vector<int>> med_elements(const Hdf5Reader& file, const std::string& kind) {
  const std::string path = kStep + "/MAI/" + kind + "/NOD";
  const std::vector<int> columns = file.ints(path);
  const auto n = static_cast<std::size_t>(file.int_attribute(path, "NBR"));
  std::vector<std::vector<int>> rows(n);
  for (std::size_t k = 0; k < columns.size(); ++k) rows[k % n].push_back(columns[k]);
  return rows;
}

std::vector<Vec3> med_points(const Hdf5Reader& file) {
  const std::vector<double> columns = file.doubles(kStep + "/NOE/COO");
  const auto n = static_cast<std::size_t>(file.int_attribute(kStep + "/NOE/COO", "NBR"));
  EXPECT_EQ(columns.size(), 3 * n);
  std::vector<Vec3> points(n);
  for (std::size_t k = 0; k < columns.size(); ++k) points[k % n][static_cast<int>(k / n)] = columns[k];
  return points;
}

/// The name of the one group of each family.
std::map<int, std::string> med_groups(const Hdf5Reader& file) {
  std::map<int, std::string> groups;
  for (const std::string kind : {"/FAS/mesh/NOEUD", "/FAS/mesh/ELEME"})
    for (const std::string& family : file.members(kind)) {
      const std::string path = kind + "/" + family;
      EXPECT_EQ(file.int_attribute(path + "/GRO", "NBR"), 1);
      const std::string name = file.bytes(path + "/GRO/NOM");
      EXPECT_EQ(name.size(), 80u);
      const int number = file.int_attribute(path, "NUM");
      EXPECT_EQ(number > 0, kind == "/FAS/mesh/NOEUD");
      EXPECT_TRUE(groups.emplace(number, name.c_str()).second);
    }
  return groups;
}

/// The names of the groups of the family that bears this one.
std::vector<std::string> med_groups_of(const Hdf5Reader& file, const std::string& family) {
  for (const std::string& name : file.members("/FAS/mesh/ELEME")) {
    if (name.substr(name.size() - std::min(name.size(), family.size())) != family) continue;
    const std::string path = "/FAS/mesh/ELEME/" + name + "/GRO", names = file.bytes(path + "/NOM");
    EXPECT_EQ(names.size(), 80u * static_cast<std::size_t>(file.int_attribute(path, "NBR")));
    std::vector<std::string> groups;
    for (std::size_t k = 0; k < names.size(); k += 80) groups.emplace_back(names.substr(k, 80).c_str());
    return groups;
  }
  return {};
}

TEST_F(Hdf5Write, MedHasAFamilyOfAllTheGroupsOfItsEntity) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.groups = {{"wet", 2, {1, 3}}, {"fixed", 2, {3}}};
  const Hdf5Reader file(write("box.med", test::plain_box_mesh(1), outline, 1.0));
  using Names = std::vector<std::string>;
  EXPECT_EQ(med_groups_of(file, "Face1"), (Names{"Face1", "wet"}));
  EXPECT_EQ(med_groups_of(file, "Face3"), (Names{"Face3", "wet", "fixed"}));
  EXPECT_EQ(med_groups_of(file, "Face4"), (Names{"Face4"}));
}

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

TEST_F(Hdf5Write, MedHasElementsInFamiliesOfOneGroupEach) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  const Hdf5Reader file(write("halves.med", mesh, {}, 0.1));
  EXPECT_EQ(file.int_attribute("/INFOS_GENERALES", "MAJ"), 3);
  EXPECT_EQ(file.int_attribute("/ENS_MAA/mesh", "DIM"), 3);
  EXPECT_EQ(file.text_attribute("/ENS_MAA/mesh", "NOM").substr(0, 33), "X               Y               Z");
  const std::vector<Vec3> points = med_points(file);
  ASSERT_EQ(points.size(), mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_EQ(points[v], Vec3(mesh.points[v] * 0.1));

  const std::map<int, std::string> groups = med_groups(file);
  const auto group_of = [&](int family) { return groups.at(family); };
  const std::vector<int> node_families = file.ints(kStep + "/NOE/FAM");
  for (std::size_t v = 0; v < points.size(); ++v) {
    const ModelRef on = mesh.point_on[v];
    if (on.dim > 0) {
      EXPECT_EQ(node_families[v], 0);
    } else {
      EXPECT_EQ(group_of(node_families[v]), "Vertex" + std::to_string(on.tag));
    }
  }
  const auto check = [&](const char* kind, const auto& elements, const std::vector<std::int32_t>& tags,
                         const char* word) {
    const auto rows = med_elements(file, kind);
    const std::vector<int> families = file.ints(kStep + "/MAI/" + kind + "/FAM");
    ASSERT_EQ(rows.size(), elements.size());
    ASSERT_EQ(families.size(), elements.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<int> nodes;
      for (const Mesh::Index v : elements[i]) nodes.push_back(static_cast<int>(v) + 1);
      if (nodes.size() == 4) std::swap(nodes[1], nodes[2]);  // MED's are turned the other way round
      EXPECT_EQ(rows[i], nodes);
      EXPECT_EQ(group_of(families[i]), word + std::to_string(tags[i]));
    }
  };
  check("SE2", mesh.edges, mesh.edge_on, "Edge");
  check("TR3", mesh.triangles, mesh.triangle_on, "Face");
  check("TE4", mesh.tets, mesh.tet_in, "Solid");
  EXPECT_EQ(file.members(kStep + "/MAI").size(), 3u);
}

/// MED's ten nodes: corners, then the middles of 1-2, 2-3, 3-1, 1-4, 2-4 and 3-4.
TEST_F(Hdf5Write, MedsMiddlesFollowItsCorners) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  const Hdf5Reader file(write("box.med", mesh));
  const std::vector<Vec3> points = med_points(file);
  constexpr std::size_t kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (const auto& [kind, corners, middles, count] :
       {std::tuple("SE3", 2, 1, mesh.edges.size()), std::tuple("TR6", 3, 3, mesh.triangles.size()),
        std::tuple("T10", 4, 6, mesh.tets.size())}) {
    const auto rows = med_elements(file, kind);
    ASSERT_EQ(rows.size(), count) << kind;
    for (const std::vector<int>& row : rows) {
      const auto at = [&](std::size_t k) { return points.at(static_cast<std::size_t>(row.at(k)) - 1); };
      for (int m = 0; m < middles; ++m)
        EXPECT_LT(
            (at(static_cast<std::size_t>(corners + m)) - 0.5 * (at(kEnds[m][0]) + at(kEnds[m][1]))).norm(),
            1e-14)
            << kind << " " << m;
      if (corners == 4) {
        EXPECT_LT(volume(at(0), at(1), at(2), at(3)), 0.0);
      }
    }
  }
}

TEST_F(Hdf5Write, MedsGroupsHaveTheNamesThatTheCadGives) {
  const Hdf5Reader file(
      write("box.med", test::plain_box_mesh(1), test::plain_box_outline(Vec3(3.0, 2.0, 1.0), true)));
  std::vector<std::string> names;
  for (const auto& group : med_groups(file)) names.push_back(group.second);
  EXPECT_EQ(std::count(names.begin(), names.end(), "body"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "Solid1"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "Face3"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "Face1"), 1);
  EXPECT_EQ(names.size(), 1u + 6u + 12u + 8u);
}

TEST_F(Hdf5Write, XdmfHasAGridForEachDimensionWithTags) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  const std::string xml = bytes_of(write("halves.xdmf", mesh, {}, 0.1));
  const Hdf5Reader file(folder_ / "halves.h5");
  const std::vector<double> points = file.doubles("/points");
  EXPECT_EQ(file.dims("/points"), (std::vector<std::uint64_t>{mesh.points.size(), 3}));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_EQ(Vec3(points[3 * v], points[3 * v + 1], points[3 * v + 2]), Vec3(mesh.points[v] * 0.1));
  const auto check = [&](const std::string& grid, const auto& elements, const std::vector<std::int32_t>& tags,
                         const std::string& topology) {
    std::vector<int> nodes;
    for (const auto& element : elements)
      for (const Mesh::Index v : element) nodes.push_back(static_cast<int>(v));
    EXPECT_EQ(file.ints("/" + grid + "/topology"), nodes) << grid;
    EXPECT_EQ(file.dims("/" + grid + "/topology"),
              (std::vector<std::uint64_t>{elements.size(), nodes.size() / elements.size()}));
    EXPECT_EQ(file.ints("/" + grid + "/tags"), tags) << grid;
    EXPECT_NE(xml.find("<Grid Name=\"" + grid + "\""), std::string::npos);
    EXPECT_NE(
        xml.find("TopologyType=\"" + topology + "\" NumberOfElements=\"" + std::to_string(elements.size())),
        std::string::npos);
    EXPECT_NE(xml.find(">halves.h5:/" + grid + "/topology<"), std::string::npos);
    EXPECT_NE(xml.find(">halves.h5:/" + grid + "/tags<"), std::string::npos);
  };
  check("mesh", mesh.tets, mesh.tet_in, "Tetrahedron");
  check("faces", mesh.triangles, mesh.triangle_on, "Triangle");
  check("edges", mesh.edges, mesh.edge_on, "Polyline");
  std::vector<std::array<Mesh::Index, 1>> vertices;
  std::vector<std::int32_t> tags;
  for (Mesh::Index v = 0; v < mesh.points.size(); ++v) {
    if (mesh.point_on[v].dim != 0) continue;
    vertices.push_back({v});
    tags.push_back(mesh.point_on[v].tag);
  }
  ASSERT_EQ(vertices.size(), 8u);
  check("vertices", vertices, tags, "Polyvertex");
}

/// VTK's: of edges 0-1, 1-2, 2-0, and of tetrahedra 0-3, 1-3, 2-3.
TEST_F(Hdf5Write, XdmfsMiddlesFollowTheCorners) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.mid = straight_mid_nodes(mesh);
  const std::string xml = bytes_of(write("box.xdmf", mesh));
  const Hdf5Reader file(folder_ / "box.h5");
  const std::vector<double> x = file.doubles("/points");
  constexpr std::size_t kEnds[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (const auto& [grid, topology, corners, middles] :
       {std::tuple("edges", "Edge_3", 2, 1), std::tuple("faces", "Triangle_6", 3, 3),
        std::tuple("mesh", "Tetrahedron_10", 4, 6)}) {
    EXPECT_NE(xml.find(std::string("TopologyType=\"") + topology + "\""), std::string::npos);
    const std::vector<int> nodes = file.ints(std::string("/") + grid + "/topology");
    for (std::size_t first = 0; first < nodes.size(); first += static_cast<std::size_t>(corners + middles)) {
      const auto at = [&](std::size_t k) {
        const std::size_t v = 3 * static_cast<std::size_t>(nodes.at(first + k));
        return Vec3(x.at(v), x.at(v + 1), x.at(v + 2));
      };
      for (int m = 0; m < middles; ++m)
        EXPECT_LT(
            (at(static_cast<std::size_t>(corners + m)) - 0.5 * (at(kEnds[m][0]) + at(kEnds[m][1]))).norm(),
            1e-14)
            << grid << " " << m;
    }
  }
}

TEST_F(Hdf5Write, XdmfTellsNamesAndEscapesThem) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), true);
  outline.entities[2][0].name = "a<b & c>d";
  const std::string xml = bytes_of(write("box & <1>.xdmf", test::plain_box_mesh(1), outline));
  EXPECT_NE(xml.find("<Information Name=\"region 1\" Value=\"body\"/>"), std::string::npos);
  EXPECT_NE(xml.find("<Information Name=\"face 1\" Value=\"a&lt;b &amp; c&gt;d\"/>"), std::string::npos);
  EXPECT_NE(xml.find(">box &amp; &lt;1&gt;.h5:/points<"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_ / "box & <1>.h5"));
}

/// Arrays of more than one part are whole.
TEST_F(Hdf5Write, LargeArraysAreWhole) {
  const fs::path path = folder_ / "large.h5";
  constexpr std::uint64_t kRows = 700'001;
  OutputFile out(path);
  Hdf5File file(out);
  file.array<std::int32_t>("/rows", {kRows, 3}, [](std::uint64_t i) { return static_cast<std::int32_t>(i); });
  file.array<double>("/column", {3 * kRows}, [](std::uint64_t i) { return 0.5 * static_cast<double>(i); });
  file.close();
  out.commit();
  const Hdf5Reader reader(path);
  const std::vector<int> rows = reader.ints("/rows");
  const std::vector<double> column = reader.doubles("/column");
  ASSERT_EQ(rows.size(), 3 * kRows);
  ASSERT_EQ(column.size(), 3 * kRows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i], static_cast<int>(i));
    ASSERT_EQ(column[i], 0.5 * static_cast<double>(i));
  }
}

TEST_F(Hdf5Write, TheSameMeshGivesTheSameBytes) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  for (const char* name : {"a.med", "a.xdmf"}) {
    const std::string first = bytes_of(write(name, mesh)), arrays = bytes_of(folder_ / "a.h5");
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(first, bytes_of(write(name, mesh)));
    EXPECT_EQ(arrays, bytes_of(folder_ / "a.h5"));
  }
}

TEST_F(Hdf5Write, WhatCannotBeWrittenLeavesNoFile) {
  const Mesh mesh = test::plain_box_mesh(1);
  EXPECT_THROW(write_mesh("/dev/null", mesh, {}, MeshFormat::kMed), OutputError);
  EXPECT_THROW(write_mesh(folder_ / "none" / "a.med", mesh, {}, MeshFormat::kMed), OutputError);
  EXPECT_THROW(write_mesh(folder_ / "a.h5", mesh, {}, MeshFormat::kXdmf), InputError);
  fs::create_directory(folder_ / "b.h5");
  EXPECT_THROW(write_mesh(folder_ / "b.xdmf", mesh, {}, MeshFormat::kXdmf), OutputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "b.h5 alone";
}

}  // namespace
}  // namespace octet
