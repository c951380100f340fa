// SPDX-License-Identifier: BSD-3-Clause
// Every format gives back what went in; nothing half-written is ever left behind.
#include "io/write.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/io/mesh_files.h"

namespace octet {
namespace {

using namespace test;

using Write = Files;

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

TEST_F(Write, MshTellsWhatIsPeriodic) {
  const Mesh mesh = test::plain_box_mesh(1);
  ModelOutline outline;
  outline.links.push_back(
      {model_face(2), model_face(1), {0, -1, 0, 2, 1, 0, 0, 3, 0, 0, 1, 4, 0, 0, 0, 1}, {{5, 1}, {7, 0}}});
  const auto section = [&](MeshFormat format) {
    write_mesh(directory_ / "a", mesh, outline, format, {.scale = 10.0});
    EXPECT_EQ(read_mesh(directory_ / "a").tets, mesh.tets);  // whoever reads passes over it
    const std::string bytes = bytes_of(directory_ / "a");
    return bytes.substr(bytes.find("$Periodic\n"));
  };
  EXPECT_EQ(section(MeshFormat::kMsh41Ascii),
            "$Periodic\n1\n2 2 1\n16 0 -1 0 20 1 0 0 30 0 0 1 40 0 0 0 1\n2\n6 2\n8 1\n$EndPeriodic\n");
  EXPECT_EQ(section(MeshFormat::kMsh22Ascii),
            "$Periodic\n1\n2 2 1\nAffine 0 -1 0 20 1 0 0 30 0 0 1 40 0 0 0 1\n2\n6 2\n8 1\n$EndPeriodic\n");
  EXPECT_EQ(section(MeshFormat::kMsh22Binary), section(MeshFormat::kMsh22Ascii));
  EXPECT_EQ(section(MeshFormat::kMsh41Binary).size(),
            std::string("$Periodic\n\n$EndPeriodic\n").size() + 8 + 12 + 8 + 128 + 8 + 4 * 8);
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

}  // namespace
}  // namespace octet
