// SPDX-License-Identifier: BSD-3-Clause
// A reader of the XML that we write ourselves, distrustful of every number in it.
#include "io/vtu_read.h"

#include <fmt/format.h>
#include <zlib.h>

#include <charconv>
#include <string>

#include "base/error.h"
#include "io/byte_cursor.h"

namespace octet {
namespace {

// The best that zlib's format can do is 1032 : 1.
constexpr std::uint64_t kMostCompression = 1100;
// A block is made room for before its bytes have proved it; ours have 1 MiB.
constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 26;

std::string_view attribute(std::string_view tag, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return {};
  const std::size_t start = at + key.size();
  const std::size_t end = tag.find('"', start);
  return end == std::string_view::npos ? std::string_view() : tag.substr(start, end - start);
}

std::uint64_t count_attribute(std::string_view tag, const std::string& name) {
  const std::string_view text = attribute(tag, name);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("the VTU file has no proper \"{}\"", name));
  return value;
}

class VtuFile {
 public:
  explicit VtuFile(std::string_view bytes) {
    const std::size_t appended = bytes.find("<AppendedData");
    const std::size_t start = bytes.find('_', appended == std::string_view::npos ? bytes.size() : appended);
    if (start == std::string_view::npos) throw InputError("the VTU file has no appended data");
    header_ = bytes.substr(0, appended);
    data_ = bytes.substr(start + 1);
    const std::string_view file = tag_at(header_.find("<VTKFile"));
    const std::string_view block = bytes.substr(appended, start - appended);
    if (attribute(file, "type") != "UnstructuredGrid" || attribute(file, "header_type") != "UInt64" ||
        attribute(file, "byte_order") != "LittleEndian" || attribute(block, "encoding") != "raw")
      throw InputError("only VTU files as Octet writes them are read (appended, raw, 64 bit headers)");
    const std::string_view compressor = attribute(file, "compressor");
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      throw InputError(fmt::format("VTU files compressed by {} are not read", compressor));
    packed_ = !compressor.empty();
    piece_ = tag_at(header_.find("<Piece"));
  }
  [[nodiscard]] std::uint64_t points() const { return count_attribute(piece_, "NumberOfPoints"); }
  [[nodiscard]] std::uint64_t cells() const { return count_attribute(piece_, "NumberOfCells"); }

  /// The named array of a section ("PointData", ...), which must have `count` values of type T.
  template <class T>
  [[nodiscard]] std::vector<T> array(const std::string& section, const std::string& name, const char* type,
                                     std::uint64_t count) const {
    const std::string_view tag = array_tag(section, name);
    if (attribute(tag, "type") != type || attribute(tag, "format") != "appended")
      throw InputError(fmt::format("the VTU array {} is not of type {}", name, type));
    const std::uint64_t offset = count_attribute(tag, "offset");
    const std::string bytes = packed_ ? unpacked(offset, name) : std::string(raw(offset, name));
    if (bytes.size() / sizeof(T) != count || bytes.size() % sizeof(T) != 0)
      throw InputError(fmt::format("the VTU array {} has a wrong length", name));
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  /// The same for an array of type Int32 or Int64.
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& section, const std::string& name,
                                                   std::uint64_t count) const {
    if (attribute(array_tag(section, name), "type") == "Int64")
      return array<std::int64_t>(section, name, "Int64", count);
    const auto narrow = array<std::int32_t>(section, name, "Int32", count);
    return {narrow.begin(), narrow.end()};
  }

 private:
  [[nodiscard]] std::string_view tag_at(std::size_t at) const {
    const std::size_t end = at == std::string_view::npos ? at : header_.find('>', at);
    if (end == std::string_view::npos) throw InputError("the file is no VTU file");
    return header_.substr(at, end - at);
  }
  [[nodiscard]] std::string_view array_tag(const std::string& section, const std::string& name) const {
    const std::size_t begin = header_.find("<" + section + ">");
    const std::size_t end = header_.find("</" + section + ">");
    const std::size_t at = header_.find(" Name=\"" + name + "\"", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos || at >= end)
      throw InputError(fmt::format("the VTU file has no array {} in {}", name, section));
    return tag_at(header_.rfind("<DataArray", at));
  }
  [[nodiscard]] std::string_view raw(std::uint64_t offset, const std::string& name) const {
    if (offset > data_.size()) throw InputError(fmt::format("the VTU array {} lies behind the end", name));
    ByteCursor in(data_.substr(offset));
    return in.take(in.checked_count(in.raw<std::uint64_t>(false), 1, "bytes"));
  }
  [[nodiscard]] std::string unpacked(std::uint64_t offset, const std::string& name) const {
    if (offset > data_.size()) throw InputError(fmt::format("the VTU array {} lies behind the end", name));
    ByteCursor in(data_.substr(offset));
    const std::uint64_t blocks = in.raw<std::uint64_t>(false);
    const std::uint64_t block_size = in.raw<std::uint64_t>(false);
    const std::uint64_t last_size = in.raw<std::uint64_t>(false);
    (void)in.checked_count(blocks, 8, "blocks");
    std::vector<std::uint64_t> packed_sizes;
    for (std::uint64_t b = 0; b < blocks; ++b) packed_sizes.push_back(in.raw<std::uint64_t>(false));
    std::string bytes;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::string_view packed = in.take(packed_sizes[b]);
      const std::uint64_t size = b + 1 == blocks && last_size != 0 ? last_size : block_size;
      if (size > kLargestBlock || size > kMostCompression * (packed.size() + 1))
        in.fail("a block's size is impossible");
      const std::size_t at = bytes.size();
      bytes.resize(at + size);
      uLongf length = static_cast<uLongf>(size);
      if (uncompress(reinterpret_cast<Bytef*>(bytes.data() + at), &length,
                     reinterpret_cast<const Bytef*>(packed.data()),
                     static_cast<uLong>(packed.size())) != Z_OK ||
          length != size)
        in.fail(fmt::format("the VTU array {} cannot be uncompressed", name));
    }
    return bytes;
  }

  std::string_view header_, data_, piece_;
  bool packed_ = false;  ///< by zlib
};

void read_points(const VtuFile& file, RawMesh& mesh) {
  const std::uint64_t n = file.points();
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw InputError("the VTU file announces too many points");
  const auto xyz = file.array<double>("Points", "Points", "Float64", 3 * n);
  const auto dim = file.array<std::int32_t>("PointData", "entity_dim", "Int32", n);
  const auto tag = file.array<std::int32_t>("PointData", "entity_tag", "Int32", n);
  for (std::size_t i = 0; i < n; ++i) {
    if (dim[i] < 0 || dim[i] > 3) throw InputError("a VTU point has an entity_dim that is not 0..3");
    mesh.node_tag.push_back(i);
    mesh.points.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    mesh.point_on.push_back({dim[i], tag[i]});
  }
}

void add_cell(RawMesh& mesh, std::uint64_t cell, std::uint8_t type, std::int32_t entity,
              const std::uint64_t* nodes, std::uint64_t count) {
  if (type == 1 && count == 1) return mesh.vertices.add(cell, entity, nodes);
  if (type == 3 && count == 2) return mesh.edges.add(cell, entity, nodes);
  if (type == 5 && count == 3) return mesh.triangles.add(cell, entity, nodes);
  if (type == 10 && count == 4) return mesh.tets.add(cell, entity, nodes);
  throw InputError(fmt::format("VTU cell {} of type {} is not read", cell, type));
}

void read_cells(const VtuFile& file, RawMesh& mesh) {
  const std::uint64_t n = file.cells();
  const auto types = file.array<std::uint8_t>("Cells", "types", "UInt8", n);
  const auto offsets = file.integers("Cells", "offsets", n);
  const auto tag = file.array<std::int32_t>("CellData", "entity_tag", "Int32", n);
  const std::int64_t length = n == 0 ? 0 : offsets.back();
  if (length < 0) throw InputError("the VTU file has a negative offset");
  const auto connectivity = file.integers("Cells", "connectivity", static_cast<std::uint64_t>(length));
  std::int64_t start = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::int64_t count = offsets[i] - start;
    if (count < 1 || count > 4 || offsets[i] > length)
      throw InputError(fmt::format("VTU cell {} has a wrong number of nodes", i));
    std::uint64_t nodes[4] = {};
    for (std::int64_t k = 0; k < count; ++k) nodes[k] = static_cast<std::uint64_t>(connectivity[start + k]);
    add_cell(mesh, i, types[i], tag[i], nodes, static_cast<std::uint64_t>(count));
    start = offsets[i];
  }
}

}  // namespace

RawMesh read_vtu(std::string_view bytes) {
  const VtuFile file(bytes);
  RawMesh mesh;
  read_points(file, mesh);
  read_cells(file, mesh);
  return mesh;
}

}  // namespace octet
