// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a VTU file, in any of the encodings that VTK's writers use.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace octet {

/// One piece of an unstructured grid. Arrays may be ASCII, base64 within the XML, or appended, raw or base64;
/// plain or compressed by zlib; with headers of 32 or 64 bits; little endian. Every read that the bytes do
/// not allow is an InputError. Keeps a view of the bytes.
class VtuFile {
 public:
  explicit VtuFile(std::string_view bytes);

  [[nodiscard]] std::uint64_t points() const;
  [[nodiscard]] std::uint64_t cells() const;
  /// Names of the arrays of real numbers with one component in a section ("PointData", "CellData").
  [[nodiscard]] std::vector<std::string> real_scalars(const std::string& section) const;
  /// The named array of a section, or its first for an empty name, which must have `count` values. T: double,
  /// std::int64_t, std::int32_t or std::uint8_t; numbers that T cannot hold are refused.
  template <class T>
  [[nodiscard]] std::vector<T> array(const std::string& section, const std::string& name,
                                     std::uint64_t count) const;

 private:
  /// An array's opening tag, and what stands between that and the closing one.
  struct Element {
    std::string_view tag, text;
  };
  [[nodiscard]] std::vector<Element> elements(const std::string& section) const;
  [[nodiscard]] Element element(const std::string& section, const std::string& name) const;
  [[nodiscard]] std::string payload(const Element& array, const std::string& name) const;
  [[nodiscard]] std::string_view appended(std::uint64_t offset, const std::string& name) const;
  [[nodiscard]] std::string unpacked(std::string_view bytes, const std::string& name) const;
  [[nodiscard]] std::uint64_t header_word(class ByteCursor& in) const;

  std::string_view xml_, data_, piece_;
  bool base64_ = false;                 ///< of the appended data
  bool packed_ = false;                 ///< by zlib
  bool wide_ = false;                   ///< headers of 64 bits
  std::vector<std::uint64_t> offsets_;  ///< of all appended arrays, ascending
};

}  // namespace octet
