// SPDX-License-Identifier: BSD-3-Clause
// Every format gives back what went in; nothing half-written is ever left behind.
#include "io/write.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/msh_read.h"
#include "io/vtu_read.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

const Vec3 kSize(3.0, 2.0, 1.0);
constexpr MeshFormat kFormats[] = {MeshFormat::kMsh41Binary, MeshFormat::kMsh41Ascii,
                                   MeshFormat::kMsh22Binary, MeshFormat::kMsh22Ascii, MeshFormat::kVtu};

/// A directory of its own for each test, removed at the end.
class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = fs::temp_directory_path() / (std::string("octet_io_") + info->name());
    fs::remove_all(directory_);
    fs::create_directories(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
  }
  fs::path directory_;
};

using Write = Files;
using Read = Files;

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Coordinates that decimal notation does not hit, and a sheared grid.
Mesh crooked_mesh() {
  Mesh mesh = test::plain_box_mesh(3);
  for (Vec3& p : mesh.points) p = Vec3(p.x() / 3.0 + 1e-17 * p.y(), -p.y() * 0.1, 1e6 + p.z() / 7.0 - p.x());
  return mesh;
}

/// Of second order, with nodes off the middles of their edges.
Mesh crooked_second_order_mesh(int cells) {
  Mesh mesh = test::plain_box_mesh(cells);
  mesh.mid = straight_mid_nodes(mesh);
  for (std::size_t m = 0; m < mesh.mid.points.size(); ++m)
    mesh.mid.points[m] += Vec3(1e-3 / 3.0, -1e-4, 1e-5) * static_cast<double>(m % 7);
  return mesh;
}

/// What read_mesh does, without the disk.
Mesh read_bytes(const std::string& bytes, MeshFormat format) {
  return assemble_mesh(format == MeshFormat::kVtu ? read_vtu(bytes) : read_msh(bytes));
}

/// Reading the file is an InputError that says so.
void expect_refused(const fs::path& path, const char* words) {
  try {
    (void)read_mesh(path);
    ADD_FAILURE() << "it is read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.points[v][i]), std::bit_cast<std::uint64_t>(b.points[v][i]));
  EXPECT_EQ(a.point_on, b.point_on);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.edge_on, b.edge_on);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_on, b.triangle_on);
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.tet_in, b.tet_in);
  EXPECT_EQ(a.mid.points, b.mid.points);
  EXPECT_EQ(a.mid.on, b.mid.on);
  EXPECT_EQ(a.mid.between, b.mid.between);
  EXPECT_EQ(a.mid.of_edges, b.mid.of_edges);
  EXPECT_EQ(a.mid.of_triangles, b.mid.of_triangles);
  EXPECT_EQ(a.mid.of_tets, b.mid.of_tets);
}

TEST_F(Write, EveryFormatGivesBackTheMeshToTheBit) {
  const Mesh mesh = crooked_mesh();
  for (const MeshFormat format : kFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    write_mesh(directory_ / "a", mesh, test::plain_box_outline(kSize, true), format);
    expect_same(mesh, read_mesh(directory_ / "a"));
  }
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Write, EveryFormatGivesBackAMeshOfSecondOrder) {
  const Mesh mesh = crooked_second_order_mesh(2);
  for (const MeshFormat format : kFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    write_mesh(directory_ / "a", mesh, test::plain_box_outline(kSize, true), format);
    expect_same(mesh, read_mesh(directory_ / "a"));
    const Mesh scaled = read_mesh(directory_ / "a", 2.0);
    EXPECT_EQ(scaled.points.back(), 2.0 * mesh.points.back());
    EXPECT_EQ(scaled.mid.points.back(), 2.0 * mesh.mid.points.back());
  }
}

/// Where the manuals put the ten nodes: which two corners each of the last six is between.
/// [Gmsh reference manual, "Node ordering"]
TEST_F(Write, NodesInMiddlesStandWhereTheManualOfMshHasThem) {
  constexpr int kBetween[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
  Mesh mesh = test::plain_box_mesh(1);
  mesh.mid = straight_mid_nodes(mesh);
  write_mesh(directory_ / "a", mesh, {}, MeshFormat::kMsh22Ascii);
  std::ifstream in(directory_ / "a");
  std::string line;
  while (std::getline(in, line) && line != "$Nodes") {
  }
  std::size_t count = 0;
  in >> count;
  std::vector<Vec3> points(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t tag = 0;
    in >> tag;
    in >> points[tag].x() >> points[tag].y() >> points[tag].z();
  }
  while (std::getline(in, line) && line != "$Elements") {
  }
  std::size_t tets = 0;
  for (in >> count; count > 0; --count) {
    int tag = 0, type = 0, tags = 0, physical = 0, elementary = 0;
    in >> tag >> type >> tags >> physical >> elementary;
    EXPECT_TRUE(type == 15 || type == 8 || type == 9 || type == 11) << type;
    std::vector<std::size_t> nodes(type == 15 ? 1 : type == 8 ? 3 : type == 9 ? 6 : 10);
    for (std::size_t& node : nodes) in >> node;
    if (type == 8) {
      EXPECT_EQ(points[nodes[2]], 0.5 * (points[nodes[0]] + points[nodes[1]]));
    }
    for (std::size_t k = 0; type == 9 && k < 3; ++k)
      EXPECT_EQ(points[nodes[3 + k]], 0.5 * (points[nodes[k]] + points[nodes[(k + 1) % 3]]));
    if (type != 11) continue;
    ++tets;
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_EQ(points[nodes[4 + k]], 0.5 * (points[nodes[kBetween[k][0]]] + points[nodes[kBetween[k][1]]]));
  }
  EXPECT_EQ(tets, mesh.tets.size());
}

TEST_F(Write, NodesInNoOrderOfEntitiesKeepTheirNumbers) {
  Mesh mesh = test::plain_box_mesh(2);
  std::swap(mesh.tets.front(), mesh.tets.back());
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  std::reverse(mesh.triangle_on.begin(), mesh.triangle_on.end());
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", mesh, {}, format);
    expect_same(mesh, read_mesh(directory_ / "a"));
  }
}

TEST_F(Write, SameMeshGivesSameBytes) {
  const Mesh mesh = crooked_mesh();
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", mesh, {}, format);
    write_mesh(directory_ / "b", mesh, {}, format);
    EXPECT_EQ(bytes_of(directory_ / "a"), bytes_of(directory_ / "b"));
  }
}

TEST_F(Write, VtuHoldsNamesAndColoursThatTheOutlineGives) {
  ModelOutline outline = test::plain_box_outline(kSize, false);
  write_mesh(directory_ / "plain", test::plain_box_mesh(1), outline, MeshFormat::kVtu);
  EXPECT_EQ(bytes_of(directory_ / "plain").find("FieldData"), std::string::npos);
  EXPECT_EQ(bytes_of(directory_ / "plain").find("colour"), std::string::npos);
  outline.entities[3][0].name = "housing";
  outline.entities[3][0].material = "steel";
  outline.entities[2][0].colour = "#ff8000";
  write_mesh(directory_ / "a", test::plain_box_mesh(1), outline, MeshFormat::kVtu);
  const std::string bytes = bytes_of(directory_ / "a");
  for (const std::string word : {"Name=\"region_names\" NumberOfTuples=\"8\"", "Name=\"region_materials\"",
                                 "Name=\"colour\" NumberOfComponents=\"3\""})
    EXPECT_NE(bytes.find(word), std::string::npos) << word;
  EXPECT_EQ(bytes.find("face_names"), std::string::npos);
  expect_same(test::plain_box_mesh(1), read_mesh(directory_ / "a"));
}

TEST_F(Write, AnEmptyMeshIsAFileToo) {
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", {}, {}, format);
    EXPECT_TRUE(read_mesh(directory_ / "a").points.empty());
  }
}

TEST_F(Write, ScaleMultipliesCoordinates) {
  const Mesh mesh = test::plain_box_mesh(1);
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", mesh, {}, format, {.scale = 0.25});
    const Mesh read = read_mesh(directory_ / "a");
    for (std::size_t v = 0; v < mesh.points.size(); ++v) EXPECT_EQ(read.points[v], 0.25 * mesh.points[v]);
  }
}

/// Lines of $PhysicalNames.
std::vector<std::string> groups_in(const std::string& text) {
  std::istringstream lines(text.substr(text.find("$PhysicalNames\n") + 15));
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> groups(std::stoul(line));
  for (std::string& group : groups) std::getline(lines, group);
  return groups;
}

TEST_F(Write, EveryEntityIsAGroupOfItsUniqueName) {
  ModelOutline outline = test::plain_box_outline(kSize, true);
  outline.entities[2][0].name = "bore \"A\"";
  outline.entities[1][4].name = "rim";
  std::vector<std::string> wanted;
  for (int v = 1; v <= 8; ++v) wanted.push_back(fmt::format("0 {0} \"Vertex{0}\"", v));
  for (int e = 1; e <= 12; ++e)
    wanted.push_back(e == 5 ? std::string("1 5 \"rim\"") : fmt::format("1 {0} \"Edge{0}\"", e));
  for (const std::string name : {"1 \"bore 'A' Face1\"", "2 \"Face2\"", "3 \"bore 'A' Face3\"", "4 \"Face4\"",
                                 "5 \"Face5\"", "6 \"Face6\""})
    wanted.push_back("2 " + name);
  wanted.push_back("3 1 \"body\"");
  write_mesh(directory_ / "a", test::plain_box_mesh(1), outline, MeshFormat::kMsh22Ascii);
  EXPECT_EQ(groups_in(bytes_of(directory_ / "a")), wanted);
  wanted.push_back("2 7 \"bore 'A'\"");  // of both
  write_mesh(directory_ / "a", test::plain_box_mesh(1), outline, MeshFormat::kMsh41Ascii);
  EXPECT_EQ(groups_in(bytes_of(directory_ / "a")), wanted);
}

TEST_F(Write, EntitiesTellTheirOwnGroupBeforeThoseOfSeveral) {
  ModelOutline outline = test::plain_box_outline(kSize, false);
  outline.entities[2][3].name = "fixed";
  outline.groups = {{"fixed", 2, {1, 3}}, {"wet", 2, {3, 4}}, {"far away", 1, {77}}};
  write_mesh(directory_ / "a", test::plain_box_mesh(1), outline, MeshFormat::kMsh41Ascii);
  const std::string text = bytes_of(directory_ / "a");
  const std::vector<std::string> groups = groups_in(text);
  ASSERT_EQ(groups.size(), 27u + 2u);
  EXPECT_EQ(groups[23], "2 4 \"fixed Face4\"");
  EXPECT_EQ(groups[27], "2 7 \"fixed\"");
  EXPECT_EQ(groups[28], "2 8 \"wet\"");
  std::istringstream lines(text.substr(text.find("$Entities\n") + 10));
  std::string line;
  for (int i = 0; i < 1 + 8 + 12; ++i) std::getline(lines, line);
  const std::vector<std::vector<int>> wanted{{1, 7}, {2}, {3, 7, 8}, {4, 8}, {5}, {6}};
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    std::getline(lines, line);
    std::istringstream words(line);
    double box = 0.0;
    std::size_t tag = 0, many = 0;
    words >> tag;
    for (int i = 0; i < 6; ++i) words >> box;
    words >> many;
    std::vector<int> numbers(many);
    for (int& number : numbers) words >> number;
    EXPECT_EQ(tag, f + 1);
    EXPECT_EQ(numbers, wanted[f]) << line;
  }
}

// meshio takes no file in which some blocks of elements are in groups and others are not.
TEST_F(Write, EveryBlockOfElementsIsInAGroupWithNamesAndWithout) {
  for (const bool named : {false, true}) {
    write_mesh(directory_ / "a", test::plain_box_mesh(1), test::plain_box_outline(kSize, named),
               MeshFormat::kMsh41Ascii);
    EXPECT_EQ(groups_in(bytes_of(directory_ / "a")).size(), 27u);
  }
}

TEST_F(Write, LongNamesAreCutBetweenCharactersAndStayUnique) {
  ModelOutline outline = test::plain_box_outline(kSize, false);
  std::string name;
  for (int i = 0; i < 4000; ++i) name += "\xC3\xA9";
  for (auto& face : outline.entities[2]) face.name = name;
  write_mesh(directory_ / "a", test::plain_box_mesh(1), outline, MeshFormat::kMsh22Ascii);
  const std::string text = bytes_of(directory_ / "a");
  const std::size_t at = text.find("2 1 \"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t end = text.find('"', at + 5);
  EXPECT_LE(end - at - 5, 127u);
  EXPECT_EQ(text.substr(end - 8, 8), "\xC3\xA9 Face1");
}

TEST_F(Write, EntitiesTellBoxesAndBounds) {
  write_mesh(directory_ / "a", test::plain_box_mesh(1), test::plain_box_outline(kSize, false),
             MeshFormat::kMsh41Ascii);
  const std::string text = bytes_of(directory_ / "a");
  EXPECT_NE(text.find("$Entities\n8 12 6 1\n1 0 0 0 1 1\n2 0 0 1 1 2\n"), std::string::npos);
  EXPECT_NE(text.find("\n1 0 0 0 0 0 1 1 1 2 1 -2\n"), std::string::npos);
  EXPECT_NE(text.find("\n1 0 0 0 3 2 1 1 1 6 "), std::string::npos);
}

TEST_F(Write, MeshesWhoseArraysDoNotFitAreRefused) {
  Mesh whole = test::plain_box_mesh(1);
  whole.mid = straight_mid_nodes(whole);
  const auto refuses = [&](const std::function<void(Mesh&)>& spoil) {
    Mesh broken = whole;
    spoil(broken);
    for (const MeshFormat format : {MeshFormat::kMsh41Binary, MeshFormat::kVtu, MeshFormat::kInp})
      EXPECT_THROW(write_mesh(directory_ / "a", broken, {}, format), InputError);
  };
  refuses([](Mesh& m) { m.mid.of_tets.clear(); });
  refuses([](Mesh& m) { m.mid.of_triangles.pop_back(); });
  refuses([](Mesh& m) { m.mid.of_edges.clear(); });
  refuses([](Mesh& m) { m.mid.of_tets[0][5] = 1000000; });
  refuses([](Mesh& m) { m.mid.on.pop_back(); });
  refuses([](Mesh& m) { m.mid.between.clear(); });
  refuses([](Mesh& m) { m.triangles[0][1] = 1000000; });
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(Write, TheOldFileSurvivesAFailure) {
  put_bytes(directory_ / "a.msh", "old");
  Mesh broken = test::plain_box_mesh(1);
  broken.tet_in.pop_back();
  EXPECT_THROW(write_mesh(directory_ / "a.msh", broken, {}, MeshFormat::kMsh41Binary), InputError);
  EXPECT_EQ(bytes_of(directory_ / "a.msh"), "old");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Write, AFullDiskIsAnError) {
  for (const MeshFormat format : kFormats)
    EXPECT_THROW(write_mesh("/dev/full", test::plain_box_mesh(2), {}, format), OutputError);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_FALSE(fs::exists("/dev/full.part0"));
}

TEST_F(Write, AMissingDirectoryIsAnError) {
  EXPECT_THROW(write_mesh(directory_ / "none" / "a.msh", test::plain_box_mesh(1), {}, MeshFormat::kVtu),
               OutputError);
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(Write, ADirectoryAsTargetIsAnError) {
  fs::create_directory(directory_ / "a.msh");
  EXPECT_THROW(write_mesh(directory_ / "a.msh", test::plain_box_mesh(1), {}, MeshFormat::kMsh41Binary),
               OutputError);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Write, ADirectoryThatCannotBeWrittenIsAnError) {
  // /proc takes no files from anybody, not even from root.
  EXPECT_THROW(write_mesh("/proc/a.msh", test::plain_box_mesh(1), {}, MeshFormat::kMsh41Binary), OutputError);
}

TEST_F(Write, ALinkIsFollowed) {
  put_bytes(directory_ / "real.msh", "old");
  fs::create_symlink("real.msh", directory_ / "link.msh");
  write_mesh(directory_ / "link.msh", test::plain_box_mesh(1), {}, MeshFormat::kMsh41Binary);
  EXPECT_TRUE(fs::is_symlink(directory_ / "link.msh"));
  EXPECT_EQ(read_mesh(directory_ / "real.msh").tets.size(), 6u);
}

TEST_F(Write, ALinkToAFileThatIsNotThereYetIsFollowed) {
  fs::create_directory(directory_ / "far");
  fs::create_symlink("middle.msh", directory_ / "link.msh");
  fs::create_symlink(directory_ / "far" / "real.msh", directory_ / "middle.msh");
  write_mesh(directory_ / "link.msh", test::plain_box_mesh(1), {}, MeshFormat::kMsh41Binary);
  EXPECT_TRUE(fs::is_symlink(directory_ / "link.msh"));
  EXPECT_TRUE(fs::is_symlink(directory_ / "middle.msh"));
  EXPECT_EQ(read_mesh(directory_ / "far" / "real.msh").tets.size(), 6u);
}

TEST(Format, IsToldByNameElseBySuffix) {
  EXPECT_EQ(mesh_format("a.msh", ""), MeshFormat::kMsh41Binary);
  EXPECT_EQ(mesh_format("a.VTU", ""), MeshFormat::kVtu);
  EXPECT_EQ(mesh_format("a.vtu", "msh"), MeshFormat::kMsh41Binary);
  EXPECT_EQ(mesh_format("a", "msh22-ascii"), MeshFormat::kMsh22Ascii);
  EXPECT_EQ(mesh_format("a", "msh22"), MeshFormat::kMsh22Binary);
  EXPECT_EQ(mesh_format("a", "msh41-ascii"), MeshFormat::kMsh41Ascii);
  EXPECT_THROW((void)mesh_format("a.ply", ""), InputError);
  EXPECT_THROW((void)mesh_format("a.msh", "ply"), InputError);
}

TEST(Format, AnXdmfFileHasASecondOneBesideIt) {
  using Files = std::vector<std::filesystem::path>;
  EXPECT_EQ(written_files("a/b.c.xdmf", MeshFormat::kXdmf), (Files{"a/b.c.xdmf", "a/b.c.h5"}));
  EXPECT_EQ(written_files("a/b.med", MeshFormat::kMed), Files{"a/b.med"});
  EXPECT_THROW((void)written_files("b.h5", MeshFormat::kXdmf), InputError);
}

TEST_F(Read, ElementsOfBothOrdersAreRefused) {
  Mesh mesh = crooked_second_order_mesh(1);
  write_mesh(directory_ / "a", mesh, {}, MeshFormat::kMsh22Ascii);
  std::string text = bytes_of(directory_ / "a");
  // The first triangle as one of first order: its three middles left out.
  std::size_t at = text.find("$Elements");
  while (text[at] != '\0') {
    at = text.find('\n', at) + 1;
    std::istringstream line(text.substr(at, text.find('\n', at) - at));
    std::size_t tag = 0, type = 0;
    if (!(line >> tag >> type) || type != 9) continue;
    std::size_t rest[5];
    for (std::size_t& number : rest) line >> number;
    std::ostringstream first_order;
    first_order << tag << " 2 2 " << rest[1] << ' ' << rest[2] << ' ' << rest[3] << ' ' << rest[4] << " 1";
    text.replace(at, text.find('\n', at) - at, first_order.str());
    break;
  }
  put_bytes(directory_ / "a", text);
  expect_refused(directory_ / "a", "of first and of second order");
}

TEST_F(Read, ANodeThatIsACornerAndAMiddleIsRefused) {
  write_mesh(directory_ / "a", crooked_second_order_mesh(1), {}, MeshFormat::kMsh41Ascii);
  std::istringstream lines(bytes_of(directory_ / "a"));
  std::string wrong;
  int tets = 0;
  for (std::string line; std::getline(lines, line); wrong += line + "\n")
    if (std::count(line.begin(), line.end(), ' ') == 10 && ++tets == 3)  // its number and ten nodes
      line.replace(line.rfind(' ') + 1, std::string::npos, "1");
  ASSERT_GE(tets, 3);
  put_bytes(directory_ / "a", wrong);
  expect_refused(directory_ / "a", "is a corner and in the middle");
}

/// Files of first order, and of second.
class ReadBadly : public Files, public ::testing::WithParamInterface<bool> {
 protected:
  static Mesh mesh_of_order() { return GetParam() ? crooked_second_order_mesh(1) : test::plain_box_mesh(1); }
};
INSTANTIATE_TEST_SUITE_P(Orders, ReadBadly, ::testing::Bool());

TEST_P(ReadBadly, EveryTruncationIsAnError) {
  const Mesh mesh = mesh_of_order();
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", mesh, test::plain_box_outline(kSize, true), format);
    const std::string whole = bytes_of(directory_ / "a");
    // The last bytes of a file are its closing tag or line end, which an array does not need.
    for (std::size_t n = 0; n + 40 < whole.size(); n += 1) {
      EXPECT_THROW((void)read_bytes(whole.substr(0, n), format), InputError)
          << static_cast<int>(format) << " " << n;
    }
  }
}

/// A VTU file with its arrays compressed by zlib in one block each, as VTK's own writers do.
std::string compressed_vtu(const std::string& vtu) {
  const std::size_t start = vtu.find('_', vtu.find("<AppendedData")) + 1;
  std::string header, data;
  std::size_t from = 0;
  for (std::size_t at = vtu.find("offset=\""); at < start; at = vtu.find("offset=\"", from)) {
    const std::size_t number = at + 8, end = vtu.find('"', number);
    const std::size_t array = start + std::stoull(vtu.substr(number, end - number));
    std::uint64_t length = 0;
    std::memcpy(&length, vtu.data() + array, sizeof length);
    uLongf packed = compressBound(length);
    std::string bytes(packed, '\0');
    EXPECT_EQ(compress(reinterpret_cast<Bytef*>(bytes.data()), &packed,
                       reinterpret_cast<const Bytef*>(vtu.data() + array + sizeof length), length),
              Z_OK);
    header += vtu.substr(from, number - from) + std::to_string(data.size());
    from = end;
    const std::uint64_t table[4] = {1, length + 1, length, packed};  // one block, not a whole one
    data.append(reinterpret_cast<const char*>(table), sizeof table);
    data.append(bytes, 0, packed);
  }
  header += vtu.substr(from, start - from);
  header.insert(header.find(" header_type"), " compressor=\"vtkZLibDataCompressor\"");
  return header + data + "\n  </AppendedData>\n</VTKFile>\n";
}

TEST_F(Read, VtuMayBeCompressed) {
  const Mesh mesh = crooked_mesh();
  const fs::path path = directory_ / "a.vtu";
  write_mesh(path, mesh, {}, MeshFormat::kVtu);
  const std::string raw = bytes_of(path), packed = compressed_vtu(raw);
  EXPECT_LT(packed.size(), raw.size());
  expect_same(read_bytes(packed, MeshFormat::kVtu), mesh);
}

TEST_P(ReadBadly, NoChangedByteEverCrashes) {
  const Mesh mesh = mesh_of_order();
  std::uint32_t random = 12345;
  const auto next = [&random] { return random = random * 1664525u + 1013904223u; };
  std::size_t refused = 0;
  for (const MeshFormat format : kFormats) {
    write_mesh(directory_ / "a", mesh, {}, format);
    const std::string whole = bytes_of(directory_ / "a");
    for (int i = 0; i < 4000; ++i) {
      std::string changed = whole;
      for (int k = 0; k < 1 + i % 4; ++k)
        changed[(next() >> 8) % changed.size()] = static_cast<char>(next() >> 16);
      try {
        const Mesh read = read_bytes(changed, format);
        EXPECT_LE(read.tets.size(), 6u);
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 4000u);
}

TEST_F(Read, BogusCountsAllocateNothing) {
  const char* files[] = {
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 9000000000000000000 1 1\n3 1 0 "
      "9000000000000000000\n1\n",
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n-1 1 1 1\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4000000000\n1 0 0 0\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 4 2000000000 1\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 nan\n$EndNodes\n$Elements\n0\n$EndElements\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n1 1 0 "
      "0\n$EndNodes\n$Elements\n0\n$EndElements\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 1 0 1 "
      "2\n$EndElements\n",
      "$MeshFormat\n3.0 0 8\n$EndMeshFormat\n",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
      "$Nodes\n0\n$EndNodes\n",
      "solid box\n",
      ""};
  for (const char* text : files) {
    put_bytes(directory_ / "a", text);
    EXPECT_THROW((void)read_mesh(directory_ / "a"), InputError) << text;
  }
  EXPECT_THROW((void)read_mesh(directory_), InputError);
  EXPECT_THROW((void)read_mesh(directory_ / "none"), InputError);
}

TEST_F(Read, ReportsOrientationAndSparseTagsAsTheyAre) {
  put_bytes(directory_ / "a",
            "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n$Comment\nwhatever $Nodes\n$EndComment\n$Nodes\n5\n"
            "70000 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 5 5 5\n$EndNodes\n$Elements\n3\n"
            "9 4 2 7 3 20 70000 30 40\n5 2 3 7 2 0 20 30 40\n6 15 2 1 4 30\n$EndElements\n");
  const Mesh mesh = read_mesh(directory_ / "a");
  ASSERT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.points[4], Vec3(0, 0, 0));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<Mesh::Index, 4>>{{0, 4, 1, 2}}));
  EXPECT_EQ(mesh.tet_in, (std::vector<std::int32_t>{3}));
  EXPECT_EQ(mesh.triangle_on, (std::vector<std::int32_t>{2}));
  EXPECT_EQ(mesh.point_on[0], model_face(2));
  EXPECT_EQ(mesh.point_on[1], model_vertex(4));
  EXPECT_EQ(mesh.point_on[3], (ModelRef{3, 0}));
  EXPECT_EQ(mesh.point_on[4], model_region(3));
}

TEST_F(Read, ParametricNodesAndUnknownSectionsOfMsh41ArePassedOver) {
  put_bytes(directory_ / "a",
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 1\n1 0 0 0 1 0 0 0 0\n$EndEntities\n"
            "$PartitionedEntities\n1\n$EndPartitionedEntities\n"
            "$Nodes\n3 4 1 4\n1 7 1 1\n2\n1 0 0.5 0.5\n2 8 1 1\n4\n0 1 0 0.25 0.75\n3 1 0 2\n1\n3\n0 0 "
            "0\n0 0 1\n$EndNodes\n"
            "$Elements\n1 1 12 12\n3 1 4 1\n12 1 2 4 3\n$EndElements\n");
  const Mesh mesh = read_mesh(directory_ / "a");
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.points[1], Vec3(1, 0, 0.5));
  EXPECT_EQ(mesh.point_on[1], model_edge(7));
  EXPECT_EQ(mesh.points[3], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.point_on[3], model_face(8));
  EXPECT_EQ(mesh.tets, (std::vector<std::array<Mesh::Index, 4>>{{0, 1, 3, 2}}));
}

TEST_F(Read, TheOtherByteOrderIsTurned) {
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  const auto put = [&bytes](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
  };
  put(1);
  bytes += "\n$EndMeshFormat\n$Nodes\n2\n";
  for (const int node : {1, 2}) {
    put(node);
    for (const double x : {0.1 * node, 2.0, -3e5}) put(x);
  }
  bytes += "\n$EndNodes\n$Elements\n1\n";
  for (const int word : {1, 1, 2, 1, 9, 8, 1, 2}) put(word);
  bytes += "\n$EndElements\n";
  put_bytes(directory_ / "a", bytes);
  const Mesh mesh = read_mesh(directory_ / "a");
  ASSERT_EQ(mesh.points.size(), 2u);
  EXPECT_EQ(mesh.points[1], Vec3(0.2, 2.0, -3e5));
  EXPECT_EQ(mesh.edges, (std::vector<std::array<Mesh::Index, 2>>{{0, 1}}));
  EXPECT_EQ(mesh.edge_on, (std::vector<std::int32_t>{8}));
}

TEST_F(Read, UnknownElementTypesAreNamed) {
  put_bytes(directory_ / "a",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 5 0 1\n"
            "$EndElements\n");
  expect_refused(directory_ / "a", "element type 5 ");
}

}  // namespace
}  // namespace octet
