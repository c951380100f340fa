// SPDX-License-Identifier: BSD-3-Clause
// Sizes from files as other programs write them.
#include "io/size_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <fstream>
#include <string>

#include "base/error.h"
#include "io/size_field_write.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

class SizeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        fs::temp_directory_path() /
        (std::string("octet_sizes_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(directory_);
    fs::create_directories(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }
  [[nodiscard]] fs::path put(const std::string& name, const std::string& bytes) const {
    std::ofstream(directory_ / name, std::ios::binary) << bytes;
    return directory_ / name;
  }
  [[nodiscard]] Background read(const std::string& bytes) const { return read_size_file(put("a", bytes)); }
  [[nodiscard]] std::string refusal(const std::string& bytes, const fs::path& mesh = {}) const {
    try {
      (void)read_size_file(put("a", bytes), mesh);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  fs::path directory_;
};

template <class T>
std::string raw(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

std::string base64(const std::string& bytes) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= bytes.size() - i ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

// --- VTU ---------------------------------------------------------------------------------------------------

/// How an array stands in a file.
enum class Encoding { kAscii, kInline, kInlinePacked, kAppendedRaw, kAppendedBase64 };

/// Two tetrahedra on a common face, five points, with these further arrays in point and cell data.
class VtuText {
 public:
  explicit VtuText(Encoding encoding) : encoding_(encoding) {}

  [[nodiscard]] std::string file(const std::string& point_data, const std::string& cell_data) {
    const std::string points =
        array("Float32", "Points", " NumberOfComponents=\"3\"",
              raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}), "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1");
    const std::string cells =
        array("Int64", "connectivity", "", raw<std::int64_t>({0, 1, 2, 3, 4, 1, 3, 2}), "0 1 2 3 4 1 3 2") +
        array("Int32", "offsets", "", raw<std::int32_t>({4, 8}), "4 8") +
        array("UInt8", "types", "", raw<std::uint8_t>({10, 10}), "10 10");
    std::string xml =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
        "byte_order=\"LittleEndian\"";
    if (encoding_ == Encoding::kInlinePacked) xml += " compressor=\"vtkZLibDataCompressor\"";
    xml +=
        "><UnstructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<PointData "
        "Scalars=\"size\">\n" +
        point_data + "</PointData>\n<CellData>\n" + cell_data + "</CellData>\n<Points>\n" + points +
        "</Points>\n<Cells>\n" + cells + "</Cells></Piece></UnstructuredGrid>\n";
    if (encoding_ == Encoding::kAppendedRaw) xml += "<AppendedData encoding=\"raw\">_" + data_;
    if (encoding_ == Encoding::kAppendedBase64) xml += "<AppendedData encoding=\"base64\">_" + data_;
    if (!data_.empty()) xml += "</AppendedData>\n";
    return xml + "</VTKFile>\n";
  }

  /// One array: its values as bytes and as text.
  [[nodiscard]] std::string array(const std::string& type, const std::string& name, const std::string& more,
                                  const std::string& bytes, const std::string& text) {
    const std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + more;
    const std::string head = raw<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())});
    switch (encoding_) {
      case Encoding::kAscii:
        return tag + " format=\"ascii\">\n" + text + "\n</DataArray>\n";
      case Encoding::kInline:
        return tag + " format=\"binary\">\n" + base64(head + bytes) + "\n</DataArray>\n";
      case Encoding::kInlinePacked: {
        uLongf packed = compressBound(bytes.size());
        std::string block(packed, '\0');
        EXPECT_EQ(compress(reinterpret_cast<Bytef*>(block.data()), &packed,
                           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
                  Z_OK);
        block.resize(packed);
        const auto size = static_cast<std::uint32_t>(bytes.size());
        return tag + " format=\"binary\">\n" +
               base64(raw<std::uint32_t>({1, size, 0, static_cast<std::uint32_t>(packed)})) + base64(block) +
               "\n</DataArray>\n";
      }
      default: {
        const std::string at = std::to_string(data_.size());
        data_ += encoding_ == Encoding::kAppendedRaw ? head + bytes : base64(head + bytes);
        return tag + " format=\"appended\" offset=\"" + at + "\"/>\n";
      }
    }
  }
  [[nodiscard]] std::string sizes(const std::string& name, double a, double b) {
    return array("Float64", name, "", raw<double>({a, b}), std::to_string(a) + " " + std::to_string(b));
  }

 private:
  Encoding encoding_;
  std::string data_;
};

TEST_F(SizeFile, VtuIsReadInEveryEncoding) {
  for (const Encoding encoding : {Encoding::kAscii, Encoding::kInline, Encoding::kInlinePacked,
                                  Encoding::kAppendedRaw, Encoding::kAppendedBase64}) {
    SCOPED_TRACE(static_cast<int>(encoding));
    VtuText vtu(encoding);
    const std::string cells = vtu.sizes("h", 0.25, 0.5);
    const Background field = read(vtu.file("", cells));
    EXPECT_EQ(field.tet_size, (std::vector<double>{0.25, 0.5}));
    ASSERT_EQ(field.tets.size(), 2u);
    EXPECT_EQ(field.tets[1], (std::array<Mesh::Index, 4>{4, 1, 3, 2}));
    EXPECT_EQ(field.points[4], Vec3(1, 1, 1));
  }
}

TEST_F(SizeFile, OfSeveralVtuArraysTheOneCalledSizeCounts) {
  VtuText vtu(Encoding::kInline);
  const std::string points = vtu.array("Float32", "size", "", raw<float>({1, 2, 3, 4, 5}), "");
  const std::string cells = vtu.sizes("error", 7.0, 8.0);
  EXPECT_EQ(read(vtu.file(points, cells)).point_size, (std::vector<double>{1, 2, 3, 4, 5}));
  const std::string refused = refusal(vtu.file("", cells + vtu.sizes("stress", 1.0, 2.0)));
  EXPECT_NE(refused.find("several arrays of real numbers (error, stress)"), std::string::npos) << refused;
  EXPECT_NE(refusal(vtu.file("", "")), "");
}

TEST_F(SizeFile, CellsThatAreNoTetrahedraAreACloudOfTheirMiddles) {
  VtuText vtu(Encoding::kAscii);
  std::string text = vtu.file("", vtu.sizes("size", 0.25, 0.5));
  const std::string quads = "9 9";  // VTK's quadrilaterals
  text.replace(text.find("10 10"), 5, quads);
  const Background field = read(text);
  EXPECT_TRUE(field.tets.empty());
  EXPECT_EQ(field.point_size, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(field.points[0], Vec3(0.25, 0.25, 0.25));
}

TEST_F(SizeFile, AWrittenFieldIsReadAsACloudOfItsBoxes) {
  SizeBoxes boxes;
  for (int c = 0; c < 12; ++c) boxes.points.emplace_back(c & 1, c >> 1 & 1, c >> 2);
  boxes.boxes = {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}};
  boxes.size = {0.5, 0.25};
  write_size_field(directory_ / "a.vtu", boxes, 2.0);
  const Background field = read_size_file(directory_ / "a.vtu");
  EXPECT_EQ(field.points, (std::vector<Vec3>{Vec3(1, 1, 1), Vec3(1, 1, 3)}));
  EXPECT_EQ(field.point_size, (std::vector<double>{1.0, 0.5}));
}

TEST_F(SizeFile, NoTruncatedVtuIsRead) {
  for (const Encoding encoding : {Encoding::kAscii, Encoding::kInline, Encoding::kInlinePacked,
                                  Encoding::kAppendedRaw, Encoding::kAppendedBase64}) {
    VtuText vtu(encoding);
    const std::string cells = vtu.sizes("h", 0.25, 0.5);
    const std::string whole = vtu.file("", cells);
    const std::size_t closing = std::string("</AppendedData>\n</VTKFile>\n").size();
    for (std::size_t n = 0; n + closing < whole.size(); n += 7)
      EXPECT_NE(refusal(whole.substr(0, n)), "") << n << " of " << static_cast<int>(encoding);
  }
}

// --- MSH ---------------------------------------------------------------------------------------------------

/// Two tetrahedra with tags 7 and 9 in MSH 2.2, ASCII.
const std::string kMesh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 "
    "1\n$EndNodes\n"
    "$Elements\n2\n7 4 2 1 1 1 2 3 4\n9 4 2 1 1 5 2 4 3\n$EndElements\n";

std::string view(const std::string& section, const std::string& name, const std::string& values) {
  return "$" + section + "\n1\n\"" + name + "\"\n1\n0.0\n3\n0\n1\n2\n" + values + "$End" + section + "\n";
}

TEST_F(SizeFile, ViewsOfElementsNodesAndTheirNodesAreRead) {
  const auto tets = [this](const std::string& text) { return read(kMesh + text).tet_size; };
  EXPECT_EQ(tets(view("ElementData", "h", "9 0.5\n7 0.25\n")), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(tets(view("ElementNodeData", "h", "7 4 1 2 0.25 3\n9 4 1 0.5 1 1\n")),
            (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(read(kMesh + view("NodeData", "h", "2 0.5\n4 0.25\n")).point_size,
            (std::vector<double>{0, 0.5, 0, 0.25, 0}));
}

TEST_F(SizeFile, PlacesAreFinite) {
  EXPECT_NE(refusal("0,0,0,1\n0,nan,0,1\n").find("is no place"), std::string::npos);
  EXPECT_NE(refusal("0,0,0,1\ninf,0,0,1\n").find("is no place"), std::string::npos);
}

TEST_F(SizeFile, OfSeveralViewsTheOneCalledSizeCounts) {
  const std::string error = view("ElementData", "error", "7 3\n9 4\n");
  EXPECT_EQ(read(kMesh + error + view("ElementData", "size", "7 1\n9 2\n")).tet_size,
            (std::vector<double>{1, 2}));
  EXPECT_NE(refusal(kMesh + error + view("NodeData", "h", "1 1\n2 2\n")), "");
  EXPECT_NE(refusal(kMesh), "");
}

TEST_F(SizeFile, BinaryViewsAreRead) {
  std::string text = "$MeshFormat\n2.2 1 8\n" + raw<std::int32_t>({1}) + "\n$EndMeshFormat\n$Nodes\n4\n";
  const double xyz[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::int32_t i = 0; i < 4; ++i)
    text += raw<std::int32_t>({i + 1}) + raw<double>({xyz[i][0], xyz[i][1], xyz[i][2]});
  text += "\n$EndNodes\n$Elements\n1\n" + raw<std::int32_t>({4, 1, 2, 7, 1, 1, 1, 2, 3, 4}) +
          "\n$EndElements\n$ElementData\n1\n\"h\"\n1\n0\n3\n0\n1\n1\n" + raw<std::int32_t>({7}) +
          raw<double>({0.125}) + "\n$EndElementData\n";
  EXPECT_EQ(read(text).tet_size, (std::vector<double>{0.125}));
}

TEST_F(SizeFile, AViewWithoutAMeshCountsAnothersElements) {
  const fs::path mesh = put("mesh.msh", kMesh);
  const std::string alone =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + view("ElementData", "h", "9 0.5\n7 0.25\n");
  EXPECT_EQ(read_size_file(put("view.msh", alone), mesh).tet_size, (std::vector<double>{0.25, 0.5}));
  EXPECT_NE(refusal(alone), "");
}

TEST_F(SizeFile, CountsOfAViewThatTheFileCannotHoldAreRefused) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$NodeData\n";
  for (const char* counts : {"9000000000000000000\n", "1\n\"h\"\n9000000000000000000\n",
                             "1\n\"h\"\n1\n0\n9000000000000000000\n"}) {
    const std::string refused = refusal(head + counts);
    EXPECT_NE(refused.find("more than the file can hold"), std::string::npos) << refused;
  }
  EXPECT_NE(refusal(head + "-1\n").find("negative"), std::string::npos);
}

// --- CSV ---------------------------------------------------------------------------------------------------

TEST_F(SizeFile, NoLineOfNumbersIsLost) {
  const Background field = read("\xEF\xBB\xBF+1.0, -2,3 ,+.5\n+1;2;+3;+4e-1\n\n1 2 -3 0.25\r\n");
  EXPECT_EQ(field.points, (std::vector<Vec3>{Vec3(1, -2, 3), Vec3(1, 2, 3), Vec3(1, 2, -3)}));
  EXPECT_EQ(field.point_size, (std::vector<double>{0.5, 0.4, 0.25}));
}

TEST_F(SizeFile, LinesThatAreNoNumbersStandBeforeAllNumbersOrAreComments) {
  EXPECT_EQ(read("from a solver\n\"x\",\"y\",\"z\",\"size\"\n1,2,3,4\n# the end\n").point_size,
            std::vector<double>{4.0});
  const auto refuses = [this](const std::string& text, const std::string& what) {
    const std::string refused = refusal(text);
    EXPECT_NE(refused.find(what), std::string::npos) << text << refused;
  };
  refuses("x,y,z,size\n1,2,3,4\n\nx,2,3,4\n", "line 4, \"x,2,3,4\"");
  refuses("x,y,z,size\n1,2,3,four\n", "line 2");
  refuses("1e999,2,3,4\n1,2,3,4\n", "line 1");
  refuses("++1,2,3,4\n1,2,3,4\n", "line 1");
  refuses("+-1,2,3,4\n1,2,3,4\n", "line 1");
  refuses("1,2,3,4\n1,2,3\n", "line 2");
}

}  // namespace
}  // namespace octet
