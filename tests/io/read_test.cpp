// SPDX-License-Identifier: BSD-3-Clause
// No file, however damaged, is read wrongly, crashes, or takes memory that it does not fill.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/msh_read.h"
#include "io/vtu_read.h"
#include "tests/io/mesh_files.h"

namespace octet {
namespace {

using namespace test;

using Read = Files;

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
