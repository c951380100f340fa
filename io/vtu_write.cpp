// SPDX-License-Identifier: BSD-3-Clause
// Arrays are compressed first, for the header in front of them needs their offsets.
#include "io/vtu_write.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <vector>

#include "base/error.h"
#include "io/msh_entities.h"

namespace octet {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says so");

constexpr std::size_t kBlock = std::size_t{1} << 20;
constexpr int kLevel = 1;  // a third of the time of the default, for a tenth more bytes
constexpr std::uint8_t kVtkType[4] = {1, 3, 5, 10};

/// The compressed arrays, one after another, each with its block table as VTK wants it.
class Appended {
 public:
  /// Returns the array's XML element.
  template <class T>
  std::string add(const char* type, const char* name, int components, const std::vector<T>& values) {
    const std::size_t offset = bytes_.size();
    compress_all(reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(T));
    const std::string width = components == 1 ? "" : fmt::format(" NumberOfComponents=\"{}\"", components);
    return fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                       type, name, width, offset);
  }
  [[nodiscard]] const std::vector<unsigned char>& bytes() const { return bytes_; }

 private:
  void put(std::size_t at, std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes_[at + i] = static_cast<unsigned char>(value >> (8 * i));
  }
  // Table: number of blocks, size of a block, size of the last one when it is not whole, compressed sizes.
  void compress_all(const unsigned char* data, std::size_t size) {
    const std::size_t blocks = (size + kBlock - 1) / kBlock;
    const std::size_t table = bytes_.size();
    bytes_.resize(table + 8 * (3 + blocks));
    put(table, blocks);
    put(table + 8, kBlock);
    put(table + 16, size % kBlock);
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t length = std::min(kBlock, size - b * kBlock);
      const std::size_t at = bytes_.size();
      uLongf packed = compressBound(static_cast<uLong>(length));
      bytes_.resize(at + packed);
      if (compress2(&bytes_[at], &packed, data + b * kBlock, static_cast<uLong>(length), kLevel) != Z_OK)
        throw OutputError("zlib cannot compress the mesh");
      bytes_.resize(at + packed);
      put(table + 8 * (3 + b), packed);
    }
  }
  std::vector<unsigned char> bytes_;
};

struct CellArrays {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> dim, tag, region;
};

template <class Element>
void add_cell(CellArrays& cells, int dim, std::int32_t tag, const Element& element) {
  for (const Mesh::Index v : element) cells.connectivity.push_back(v);
  cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
  cells.types.push_back(kVtkType[dim]);
  cells.dim.push_back(dim);
  cells.tag.push_back(tag);
  cells.region.push_back(dim == 3 ? tag : 0);
}

CellArrays cell_arrays(const Mesh& mesh, const ElementGroups& groups) {
  CellArrays cells;
  const std::size_t n = groups.total;
  cells.connectivity.reserve(4 * n);
  for (auto* column : {&cells.dim, &cells.tag, &cells.region}) column->reserve(n);
  cells.offsets.reserve(n);
  cells.types.reserve(n);
  for (const std::uint32_t v : groups.vertex_nodes)
    add_cell(cells, 0, mesh.point_on[v].tag, std::array<Mesh::Index, 1>{v});
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) add_cell(cells, 1, mesh.edge_on[i], mesh.edges[i]);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    add_cell(cells, 2, mesh.triangle_on[i], mesh.triangles[i]);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) add_cell(cells, 3, mesh.tet_in[i], mesh.tets[i]);
  return cells;
}

std::string add_points(Appended& data, const Mesh& mesh, double scale) {
  std::vector<double> xyz;
  xyz.reserve(3 * mesh.points.size());
  for (const Vec3& p : mesh.points)
    for (int i = 0; i < 3; ++i) xyz.push_back(p[i] * scale);
  return data.add("Float64", "Points", 3, xyz);
}

std::string add_point_data(Appended& data, const Mesh& mesh) {
  std::vector<std::int32_t> dim, tag;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    dim.push_back(node_entity(mesh, v).dim);
    tag.push_back(node_entity(mesh, v).tag);
  }
  const std::string first = data.add("Int32", "entity_dim", 1, dim);
  return first + data.add("Int32", "entity_tag", 1, tag);
}

}  // namespace

void write_vtu(OutputFile& file, const Mesh& mesh, double scale) {
  Appended data;
  const CellArrays cells = cell_arrays(mesh, group_elements(mesh));
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
      "  <UnstructuredGrid>\n";
  xml += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.points.size(),
                     cells.types.size());
  xml += "      <PointData>\n" + add_point_data(data, mesh) + "      </PointData>\n      <CellData>\n";
  xml += data.add("Int32", "entity_dim", 1, cells.dim);
  xml += data.add("Int32", "entity_tag", 1, cells.tag);
  xml += data.add("Int32", "region", 1, cells.region);
  xml += "      </CellData>\n      <Points>\n" + add_points(data, mesh, scale) +
         "      </Points>\n      <Cells>\n";
  xml += data.add("Int64", "connectivity", 1, cells.connectivity);
  xml += data.add("Int64", "offsets", 1, cells.offsets);
  xml += data.add("UInt8", "types", 1, cells.types);
  xml += "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  file.write(xml);
  file.write(data.bytes().data(), data.bytes().size());
  file.write("\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace octet
