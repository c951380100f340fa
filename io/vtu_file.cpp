// SPDX-License-Identifier: BSD-3-Clause
// A reader of VTK's XML that knows no more XML than that, distrustful of every number in it.
#include "io/vtu_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/error.h"
#include "io/byte_cursor.h"

namespace octet {
namespace {

// The best that zlib's format can do is 1032 : 1.
constexpr std::uint64_t kMostCompression = 1100;
// A block is made room for before its bytes have proved it; those of common writers have 1 MiB at most.
constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 26;

constexpr auto kNowhere = std::string_view::npos;

std::string_view attribute(std::string_view tag, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const std::size_t at = tag.find(key);
  if (at == kNowhere) return {};
  const std::size_t start = at + key.size();
  const std::size_t end = tag.find('"', start);
  return end == kNowhere ? std::string_view() : tag.substr(start, end - start);
}

std::uint64_t count_attribute(std::string_view tag, const std::string& name) {
  const std::string_view text = attribute(tag, name);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("the VTU file has no proper \"{}\"", name));
  return value;
}

std::string_view tag_at(std::string_view xml, std::size_t at) {
  const std::size_t end = at == kNowhere ? at : xml.find('>', at);
  if (end == kNowhere) throw InputError("the file is no VTU file");
  return xml.substr(at, end - at);
}

/// Groups of four characters are decoded by themselves, so padding may stand amid them: compressed arrays
/// are two runs, one behind the other.
std::string from_base64(std::string_view text) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const std::size_t digit = kDigits.find(c);
    if (digit == kNowhere && c != '=') throw InputError(fmt::format("\"{}\" is no base64 digit", c));
    padding += c == '=' ? 1 : 0;
    group = group << 6 | (c == '=' ? 0U : static_cast<std::uint32_t>(digit));
    if (++digits < 4) continue;
    for (int k = 0; k < 3 - std::min(padding, 3); ++k)
      bytes += static_cast<char>(group >> (16 - 8 * k) & 0xFFU);
    group = 0;
    digits = padding = 0;
  }
  return bytes;
}

template <class T, class From>
T converted(From value, const std::string& name) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    bool fits = false;
    if constexpr (std::is_integral_v<From>) fits = std::in_range<T>(value);
    if (!fits) throw InputError(fmt::format("the VTU array {} has numbers that do not belong there", name));
    return static_cast<T>(value);
  }
}

template <class T, class From>
std::vector<T> values_of(const std::string& bytes, const std::string& name) {
  if (bytes.size() % sizeof(From) != 0)
    throw InputError(fmt::format("the VTU array {} has a wrong length", name));
  std::vector<T> values(bytes.size() / sizeof(From));
  if constexpr (std::is_same_v<T, From>) {
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  } else {
    for (std::size_t i = 0; i < values.size(); ++i) {
      From value;
      std::memcpy(&value, bytes.data() + i * sizeof(From), sizeof(From));
      values[i] = converted<T>(value, name);
    }
  }
  return values;
}

template <class T>
std::vector<T> values_of(std::string_view type, const std::string& bytes, const std::string& name) {
  if (type == "Float64") return values_of<T, double>(bytes, name);
  if (type == "Float32") return values_of<T, float>(bytes, name);
  if (type == "Int64") return values_of<T, std::int64_t>(bytes, name);
  if (type == "UInt64") return values_of<T, std::uint64_t>(bytes, name);
  if (type == "Int32") return values_of<T, std::int32_t>(bytes, name);
  if (type == "UInt32") return values_of<T, std::uint32_t>(bytes, name);
  if (type == "Int16") return values_of<T, std::int16_t>(bytes, name);
  if (type == "UInt16") return values_of<T, std::uint16_t>(bytes, name);
  if (type == "Int8") return values_of<T, std::int8_t>(bytes, name);
  if (type == "UInt8") return values_of<T, std::uint8_t>(bytes, name);
  throw InputError(fmt::format("the VTU array {} is of the unknown type \"{}\"", name, type));
}

template <class T>
std::vector<T> values_of_text(std::string_view text, const std::string& name) {
  std::vector<T> values;
  ByteCursor in(text);
  while (!in.at_end()) {
    if constexpr (std::is_floating_point_v<T>) {
      values.push_back(in.real());
    } else {
      values.push_back(converted<T>(in.integer(), name));
    }
  }
  return values;
}

}  // namespace

VtuFile::VtuFile(std::string_view bytes) {
  const std::size_t block_at = bytes.find("<AppendedData");
  xml_ = bytes.substr(0, block_at);
  const std::string_view file = tag_at(xml_, xml_.find("<VTKFile"));
  if (attribute(file, "type") != "UnstructuredGrid" || attribute(file, "byte_order") != "LittleEndian")
    throw InputError("only VTU files of little endian unstructured grids are read");
  const std::string_view compressor = attribute(file, "compressor");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    throw InputError(fmt::format("VTU files compressed by {} are not read", compressor));
  packed_ = !compressor.empty();
  wide_ = attribute(file, "header_type") == "UInt64";
  if (block_at != kNowhere) {
    const std::size_t start = bytes.find('_', block_at);
    if (start == kNowhere) throw InputError("the VTU file ends before its appended data");
    const std::string_view encoding = attribute(bytes.substr(block_at, start - block_at), "encoding");
    if (encoding != "raw" && encoding != "base64")
      throw InputError(fmt::format("appended data in the encoding \"{}\" are not read", encoding));
    base64_ = encoding == "base64";
    data_ = bytes.substr(start + 1);
    if (base64_) data_ = data_.substr(0, data_.find('<'));
  } else if (bytes.find("</VTKFile>") == kNowhere) {
    throw InputError("the VTU file ends too early");
  }
  const std::size_t piece = xml_.find("<Piece");
  piece_ = tag_at(xml_, piece);
  if (xml_.find("<Piece", piece + 1) != kNowhere)
    throw InputError("VTU files of several pieces are not read");
  for (std::size_t at = xml_.find(" offset=\""); at != kNowhere; at = xml_.find(" offset=\"", at + 1))
    offsets_.push_back(count_attribute(xml_.substr(at), "offset"));
  std::sort(offsets_.begin(), offsets_.end());
}

std::uint64_t VtuFile::points() const { return count_attribute(piece_, "NumberOfPoints"); }

std::uint64_t VtuFile::cells() const { return count_attribute(piece_, "NumberOfCells"); }

std::vector<VtuFile::Element> VtuFile::elements(const std::string& section) const {
  // The piece's own sections; a grid may have field data in front of it.
  const std::string_view xml = xml_.substr(static_cast<std::size_t>(piece_.data() - xml_.data()));
  const std::size_t end = xml.find("</" + section + ">");
  std::size_t at = xml.find("<" + section);
  while (at != kNowhere && at + section.size() + 1 < xml.size() && xml[at + section.size() + 1] != '>' &&
         xml[at + section.size() + 1] != ' ')
    at = xml.find("<" + section, at + 1);
  std::vector<Element> found;
  if (at == kNowhere || end == kNowhere) return found;
  constexpr std::string_view kArray = "<DataArray";
  for (at = xml.find(kArray, at); at < end; at = xml.find(kArray, at + 1)) {
    const std::string_view tag = tag_at(xml, at);
    std::string_view text;
    if (tag.back() != '/') {
      const std::size_t start = at + tag.size() + 1;
      text = xml.substr(start, xml.find("</DataArray", start) - start);
    }
    found.push_back({tag, text});
  }
  return found;
}

VtuFile::Element VtuFile::element(const std::string& section, const std::string& name) const {
  for (const Element& element : elements(section))
    if (name.empty() || attribute(element.tag, "Name") == name) return element;
  throw InputError(fmt::format("the VTU file has no array {} in {}", name, section));
}

std::vector<std::string> VtuFile::real_scalars(const std::string& section) const {
  std::vector<std::string> names;
  for (const Element& element : elements(section)) {
    const std::string_view components = attribute(element.tag, "NumberOfComponents");
    if (attribute(element.tag, "type").starts_with("Float") && (components.empty() || components == "1"))
      names.emplace_back(attribute(element.tag, "Name"));
  }
  return names;
}

std::uint64_t VtuFile::header_word(ByteCursor& in) const {
  return wide_ ? in.raw<std::uint64_t>(false) : in.raw<std::uint32_t>(false);
}

std::string_view VtuFile::appended(std::uint64_t offset, const std::string& name) const {
  if (offset > data_.size()) throw InputError(fmt::format("the VTU array {} lies behind the end", name));
  const auto next = std::upper_bound(offsets_.begin(), offsets_.end(), offset);
  return data_.substr(offset, next == offsets_.end() || !base64_ ? kNowhere : *next - offset);
}

std::string VtuFile::unpacked(std::string_view bytes, const std::string& name) const {
  ByteCursor in(bytes);
  const std::uint64_t blocks = header_word(in), block_size = header_word(in), last_size = header_word(in);
  (void)in.checked_count(blocks, wide_ ? 8 : 4, "blocks");
  std::vector<std::uint64_t> packed_sizes;
  for (std::uint64_t b = 0; b < blocks; ++b) packed_sizes.push_back(header_word(in));
  std::string whole;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::string_view packed = in.take(packed_sizes[b]);
    const std::uint64_t size = b + 1 == blocks && last_size != 0 ? last_size : block_size;
    if (size > kLargestBlock || size > kMostCompression * (packed.size() + 1))
      in.fail("a block's size is impossible");
    const std::size_t at = whole.size();
    whole.resize(at + size);
    uLongf length = static_cast<uLongf>(size);
    if (uncompress(reinterpret_cast<Bytef*>(whole.data() + at), &length,
                   reinterpret_cast<const Bytef*>(packed.data()),
                   static_cast<uLong>(packed.size())) != Z_OK ||
        length != size)
      in.fail(fmt::format("the VTU array {} cannot be uncompressed", name));
  }
  return whole;
}

std::string VtuFile::payload(const Element& array, const std::string& name) const {
  const std::string_view format = attribute(array.tag, "format");
  const bool inside = format == "binary";
  if (!inside && format != "appended")
    throw InputError(fmt::format("the VTU array {} is in the unknown format \"{}\"", name, format));
  std::string_view bytes = inside ? array.text : appended(count_attribute(array.tag, "offset"), name);
  std::string decoded;
  if (inside || base64_) {
    decoded = from_base64(bytes);
    bytes = decoded;
  }
  if (packed_) return unpacked(bytes, name);
  ByteCursor in(bytes);
  const std::uint64_t length = header_word(in);
  return std::string(in.take(in.checked_count(length, 1, "bytes")));
}

template <class T>
std::vector<T> VtuFile::array(const std::string& section, const std::string& name,
                              std::uint64_t count) const {
  const Element found = element(section, name);
  std::vector<T> values = attribute(found.tag, "format") == "ascii"
                              ? values_of_text<T>(found.text, name)
                              : values_of<T>(attribute(found.tag, "type"), payload(found, name), name);
  if (values.size() != count)
    throw InputError(fmt::format("the VTU array {} has {} values instead of {}", name, values.size(), count));
  return values;
}

template std::vector<double> VtuFile::array(const std::string&, const std::string&, std::uint64_t) const;
template std::vector<std::int64_t> VtuFile::array(const std::string&, const std::string&,
                                                  std::uint64_t) const;
template std::vector<std::int32_t> VtuFile::array(const std::string&, const std::string&,
                                                  std::uint64_t) const;
template std::vector<std::uint8_t> VtuFile::array(const std::string&, const std::string&,
                                                  std::uint64_t) const;

}  // namespace octet
