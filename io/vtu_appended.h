// SPDX-License-Identifier: BSD-3-Clause
// Raw arrays behind the XML of a VTU file, told first and written as they are made.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/output_file.h"

namespace octet {

static_assert(std::endian::native == std::endian::little, "the head says so");

inline constexpr const char* kVtuHead =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n";

template <class T>
inline constexpr const char* kVtuType = nullptr;
template <>
inline constexpr const char* kVtuType<double> = "Float64";
template <>
inline constexpr const char* kVtuType<std::uint8_t> = "UInt8";
template <>
inline constexpr const char* kVtuType<std::int32_t> = "Int32";
template <>
inline constexpr const char* kVtuType<std::int64_t> = "Int64";

/// The arrays in the order of their offsets, told first and written afterwards.
class VtuAppended {
 public:
  /// Returns the XML element of an array of n items; make(item, values) writes the `width(item)` values of an
  /// item, `total` in all.
  template <class T, class Width, class Make>
  std::string add(const char* name, int components, std::size_t n, std::uint64_t total, const Width& width,
                  const Make& make) {
    const std::string shape =
        components == 1 ? std::string() : fmt::format(" NumberOfComponents=\"{}\"", components);
    const std::string element =
        fmt::format("        <DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                    kVtuType<T>, name, shape, offset_);
    const std::uint64_t length = total * sizeof(T);
    offset_ += sizeof length + length;
    writers_.push_back([=](OutputFile& file) {
      file.put(length);
      file.write_blocks(n, kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
        T values[kMostValues];
        for (std::size_t i = first; i < last; ++i) {
          make(i, values);
          bytes.append(reinterpret_cast<const char*>(values), width(i) * sizeof(T));
        }
      });
    });
    return element;
  }
  /// One value an item.
  template <class T, class Value>
  std::string add(const char* name, std::size_t n, const Value& value) {
    return add<T>(
        name, 1, n, n, [](std::size_t) { return std::size_t{1}; },
        [=](std::size_t i, T* values) { values[0] = static_cast<T>(value(i)); });
  }
  /// Field data: an array of bytes whose length is its own.
  std::string add_text(const std::string& name, const std::string& text) {
    const std::string element = fmt::format(
        "      <DataArray type=\"UInt8\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        name, text.size(), offset_);
    const std::uint64_t length = text.size();
    offset_ += sizeof length + length;
    writers_.push_back([=](OutputFile& file) {
      file.put(length);
      file.write(text);
    });
    return element;
  }
  /// The file: `xml`, which begins with kVtuHead and ends behind the piece, and the arrays.
  void write(OutputFile& file, const std::string& xml) const {
    file.write(xml);
    file.write("  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_");
    for (const auto& writer : writers_) writer(file);
    file.write("\n  </AppendedData>\n</VTKFile>\n");
  }

 private:
  static constexpr std::size_t kMostValues = 10;  // of an item: nodes of a tetrahedron of second order
  std::uint64_t offset_ = 0;
  std::vector<std::function<void(OutputFile&)>> writers_;
};

}  // namespace octet
