// SPDX-License-Identifier: BSD-3-Clause
// What readers of MED, XDMF and CGNS find in the files, read by HDF5's library.
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

/// A text as it lies in an attribute of so many bytes.
std::string padded(std::string text, std::size_t bytes) {
  text.resize(bytes);
  return text;
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

/// A node of CGNS, whose attributes say what it is; its data are within.
std::string cgns_node(const Hdf5Reader& file, const std::string& path, const std::string& label,
                      const std::string& type) {
  EXPECT_EQ(file.text_attribute(path, "name"), padded(path.substr(path.rfind('/') + 1), 33)) << path;
  EXPECT_EQ(file.text_attribute(path, "label"), padded(label, 33)) << path;
  EXPECT_EQ(file.text_attribute(path, "type"), padded(type, 3)) << path;
  EXPECT_EQ(file.int_attribute(path, "flags"), 1) << path;
  EXPECT_EQ(file.has(path + "/ data"), type != "MT") << path;
  return path + "/ data";
}

constexpr const char* kZone = "/mesh/Zone 1";

/// The nodes, from 1, of each element of a section, whose numbers go on from `first`.
std::vector<std::vector<int>> cgns_elements(const Hdf5Reader& file, const std::string& name, int type,
                                            std::size_t nodes, int first) {
  const std::string path = std::string(kZone) + "/" + name;
  EXPECT_EQ(file.ints(cgns_node(file, path, "Elements_t", "I4")), (std::vector{type, 0}));
  const std::vector<int> flat =
      file.ints(cgns_node(file, path + "/ElementConnectivity", "DataArray_t", "I4"));
  EXPECT_EQ(flat.size() % nodes, 0u);
  const auto n = static_cast<int>(flat.size() / nodes);
  EXPECT_EQ(file.ints(cgns_node(file, path + "/ElementRange", "IndexRange_t", "I4")),
            (std::vector{first, first + n - 1}));
  std::vector<std::vector<int>> elements;
  for (std::size_t i = 0; i < flat.size(); i += nodes)
    elements.emplace_back(flat.begin() + static_cast<std::ptrdiff_t>(i),
                          flat.begin() + static_cast<std::ptrdiff_t>(i + nodes));
  return elements;
}

std::vector<Vec3> cgns_points(const Hdf5Reader& file) {
  std::vector<Vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string path = std::string(kZone) + "/GridCoordinates/Coordinate" + "XYZ"[axis];
    const std::vector<double> values = file.doubles(cgns_node(file, path, "DataArray_t", "R8"));
    points.resize(values.size());
    for (std::size_t v = 0; v < values.size(); ++v) points[v][axis] = values[v];
  }
  return points;
}

TEST_F(Hdf5Write, CgnsHasASectionForEachRegionAndFace) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  const Hdf5Reader file(write("halves.cgns", mesh, {}, 0.1));
  EXPECT_EQ(file.text_attribute("/", "label"), padded("Root Node of HDF5 File", 33));
  EXPECT_EQ(file.bytes("/ format").substr(0, 14), "IEEE_LITTLE_32");
  EXPECT_NEAR(file.doubles(cgns_node(file, "/CGNSLibraryVersion", "CGNSLibraryVersion_t", "R4"))[0], 3.1,
              1e-6);
  EXPECT_EQ(file.ints(cgns_node(file, "/mesh", "CGNSBase_t", "I4")), (std::vector{3, 3}));
  EXPECT_EQ(file.dims("/mesh/Zone 1/ data"), (std::vector<std::uint64_t>{3, 1}));
  EXPECT_EQ(file.ints(cgns_node(file, kZone, "Zone_t", "I4")),
            (std::vector{static_cast<int>(mesh.points.size()), static_cast<int>(mesh.tets.size()), 0}));
  EXPECT_EQ(file.bytes(cgns_node(file, "/mesh/Zone 1/ZoneType", "ZoneType_t", "C1")), "Unstructured");
  // The library goes through nodes as they were made.
  EXPECT_EQ(file.members("/", H5_INDEX_CRT_ORDER),
            (std::vector<std::string>{" format", " hdf5version", "CGNSLibraryVersion", "mesh"}));
  EXPECT_EQ(file.members(kZone, H5_INDEX_CRT_ORDER)[1], "ZoneType");

  const std::vector<Vec3> points = cgns_points(file);
  ASSERT_EQ(points.size(), mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_EQ(points[v], Vec3(mesh.points[v] * 0.1));
  int next = 1;
  for (const int region : {1, 2}) {
    const auto tets = cgns_elements(file, "Solid" + std::to_string(region), 10, 4, next);
    EXPECT_EQ(static_cast<long>(tets.size()), std::count(mesh.tet_in.begin(), mesh.tet_in.end(), region));
    const auto at = [&](const std::vector<int>& tet, std::size_t i) {
      return points[static_cast<std::size_t>(tet[i] - 1)];
    };
    for (const auto& tet : tets) EXPECT_GT(volume(at(tet, 0), at(tet, 1), at(tet, 2), at(tet, 3)), 0.0);
    next += static_cast<int>(tets.size());
  }
  const int faces = *std::max_element(mesh.triangle_on.begin(), mesh.triangle_on.end());
  for (int face = 1; face <= faces; ++face) {
    const std::string name = "Face" + std::to_string(face);
    const auto triangles = cgns_elements(file, name, 5, 3, next);
    std::vector<std::vector<int>> own;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.triangle_on[t] == face) {
        own.emplace_back();
        for (const Mesh::Index v : mesh.triangles[t]) own.back().push_back(static_cast<int>(v) + 1);
      }
    EXPECT_EQ(triangles, own) << name;
    const std::string condition = "/mesh/Zone 1/ZoneBC/" + name;
    EXPECT_EQ(file.bytes(cgns_node(file, condition, "BC_t", "C1")), "FamilySpecified");
    EXPECT_EQ(file.ints(cgns_node(file, condition + "/PointRange", "IndexRange_t", "I4")),
              (std::vector{next, next + static_cast<int>(own.size()) - 1}));
    EXPECT_EQ(file.dims(condition + "/PointRange/ data"), (std::vector<std::uint64_t>{2, 1}));
    EXPECT_EQ(file.bytes(cgns_node(file, condition + "/GridLocation", "GridLocation_t", "C1")), "FaceCenter");
    EXPECT_EQ(file.bytes(cgns_node(file, condition + "/FamilyName", "FamilyName_t", "C1")), name);
    cgns_node(file, "/mesh/" + name, "Family_t", "MT");
    next += static_cast<int>(own.size());
  }
}

TEST_F(Hdf5Write, CgnsHasFamiliesForGroupsOfFaces) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.groups = {{"wet", 2, {1, 3}}, {"fixed", 2, {3}}};
  const Hdf5Reader file(write("box.cgns", test::plain_box_mesh(1), outline, 1.0));
  const auto further = [&](const std::string& face, int number) {
    const std::string path = "/mesh/Zone 1/ZoneBC/" + face + "/AdditionalFamilyName" + std::to_string(number);
    return file.has(path) ? file.bytes(cgns_node(file, path, "AdditionalFamilyName_t", "C1")) : "";
  };
  for (const char* family : {"wet", "fixed"})
    cgns_node(file, std::string("/mesh/") + family, "Family_t", "MT");
  EXPECT_EQ(further("Face1", 1), "wet");
  EXPECT_EQ(further("Face1", 2), "");
  EXPECT_EQ(further("Face3", 1), "wet");
  EXPECT_EQ(further("Face3", 2), "fixed");
  EXPECT_EQ(further("Face4", 1), "");
}

TEST_F(Hdf5Write, CgnsTakesNamesThatItsOwnNodesHave) {
  ModelOutline outline = test::plain_box_outline(Vec3(3.0, 2.0, 1.0), false);
  outline.groups = {{"zone", 2, {1, 3}}, {"mesh", 2, {3}}, {"ZoneBC", 2, {2}}};
  outline.entities[2][4].name = "ZoneBC";
  outline.entities[2][5].name = "GridCoordinates";
  const Hdf5Reader file(write("box.cgns", test::plain_box_mesh(1), outline, 1.0));
  for (const char* name : {"GridCoordinates", "ZoneBC", "ZoneType"})
    EXPECT_NE(file.text_attribute(std::string(kZone) + "/" + name, "label"), padded("Elements_t", 33));
  std::size_t sections = 0;
  for (const std::string& name : file.members(kZone))
    if (name.front() != ' ' &&
        file.text_attribute(std::string(kZone) + "/" + name, "label") == padded("Elements_t", 33))
      ++sections;
  EXPECT_EQ(sections, 7u) << "a region and six faces";
}

TEST_F(Hdf5Write, CgnsHasMiddlesWhereItsOrderHasThem) {
  Mesh mesh = test::plain_box_mesh(1);
  mesh.mid = straight_mid_nodes(mesh);
  const Hdf5Reader file(write("box.cgns", mesh));
  const std::vector<Vec3> points = cgns_points(file);
  const auto is_half_way = [&](const std::vector<int>& nodes, std::size_t mid, std::size_t a, std::size_t b) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(nodes[i] - 1)]; };
    return (at(mid) - 0.5 * (at(a) + at(b))).norm() < 1e-12;
  };
  const auto tets = cgns_elements(file, "Solid1", 11, 10, 1);
  ASSERT_EQ(tets.size(), mesh.tets.size());
  for (const auto& tet : tets) {
    EXPECT_TRUE(is_half_way(tet, 4, 0, 1) && is_half_way(tet, 5, 1, 2) && is_half_way(tet, 6, 2, 0));
    EXPECT_TRUE(is_half_way(tet, 7, 0, 3) && is_half_way(tet, 8, 1, 3) && is_half_way(tet, 9, 2, 3));
  }
  const auto triangles = cgns_elements(file, "Face1", 6, 6, static_cast<int>(tets.size()) + 1);
  for (const auto& triangle : triangles)
    EXPECT_TRUE(is_half_way(triangle, 3, 0, 1) && is_half_way(triangle, 4, 1, 2) &&
                is_half_way(triangle, 5, 2, 0));
}

TEST_F(Hdf5Write, TheSameMeshGivesTheSameBytes) {
  const Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  for (const char* name : {"a.med", "a.xdmf", "a.cgns"}) {
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
