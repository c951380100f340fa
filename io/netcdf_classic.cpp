// SPDX-License-Identifier: BSD-3-Clause
// The header's grammar, as the format's specification gives it.
#include "io/netcdf_classic.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/check.h"

namespace octet {
namespace {

constexpr std::int32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
constexpr std::uint64_t kWord = 4;  // everything begins at a multiple of it
constexpr std::uint64_t kRecords = 0;

std::uint64_t bytes_of(NetcdfClassic::Type type) {
  switch (type) {
    case NetcdfClassic::Type::kChar:
      return 1;
    case NetcdfClassic::Type::kInt:
    case NetcdfClassic::Type::kFloat:
      return 4;
    case NetcdfClassic::Type::kDouble:
      return 8;
  }
  return 0;
}

std::uint64_t padded(std::uint64_t bytes) { return (bytes + kWord - 1) / kWord * kWord; }

template <class Word>
void append_word(std::string& bytes, Word word) {
  for (int shift = 8 * static_cast<int>(sizeof word) - 8; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<char>(word >> shift & 0xff));
}

/// The words of a header: lengths and counts have 64 bits in a wide one.
struct Header {
  bool wide = false;
  std::string bytes;

  void tag(std::int32_t value) { append_file_order(bytes, value); }
  void offset(std::uint64_t value) { append_word(bytes, value); }
  void count(std::uint64_t value) {
    if (wide)
      append_word(bytes, value);
    else
      append_word(bytes, static_cast<std::uint32_t>(value));
  }
  void text(const std::string& text) {
    count(text.size());
    bytes += text;
    bytes.append(padded(text.size()) - text.size(), '\0');
  }
  void list(std::int32_t kind, std::size_t size) {
    tag(size == 0 ? 0 : kind);
    count(size);
  }
  void attributes(const std::vector<NetcdfClassic::Attribute>& all) {
    using Type = NetcdfClassic::Type;
    list(kAttributes, all.size());
    for (const auto& [name, value] : all) {
      text(name);
      if (const auto* words = std::get_if<std::string>(&value)) {
        tag(static_cast<std::int32_t>(Type::kChar));
        text(*words);
      } else if (const auto* number = std::get_if<std::int32_t>(&value)) {
        tag(static_cast<std::int32_t>(Type::kInt));
        count(1);
        append_file_order(bytes, *number);
      } else {
        tag(static_cast<std::int32_t>(Type::kFloat));
        count(1);
        append_file_order(bytes, std::get<float>(value));
      }
    }
  }
};

}  // namespace

void append_file_order(std::string& bytes, std::int32_t value) {
  append_word(bytes, static_cast<std::uint32_t>(value));
}
void append_file_order(std::string& bytes, float value) {
  append_word(bytes, std::bit_cast<std::uint32_t>(value));
}
void append_file_order(std::string& bytes, double value) {
  append_word(bytes, std::bit_cast<std::uint64_t>(value));
}

NetcdfClassic::Dimension NetcdfClassic::dimension(const std::string& name, std::uint64_t length) {
  OCTET_CHECK(length > 0);
  dimensions_.push_back({name, length});
  return {dimensions_.size() - 1};
}

NetcdfClassic::Dimension NetcdfClassic::records(const std::string& name) {
  dimensions_.push_back({name, kRecords});
  return {dimensions_.size() - 1};
}

void NetcdfClassic::variable(const std::string& name, Type type, const std::vector<Dimension>& dimensions,
                             std::function<void(OutputFile&)> write, std::vector<Attribute> attributes) {
  Variable variable{name, type, {}, std::move(attributes), std::move(write)};
  variable.bytes = bytes_of(type);
  for (const Dimension& dimension : dimensions) {
    const std::uint64_t length = dimensions_[dimension.number].length;
    variable.dimensions.push_back(dimension.number);
    if (length == kRecords)
      variable.of_records = true;
    else
      variable.bytes *= length;
  }
  variables_.push_back(std::move(variable));
}

std::string NetcdfClassic::header(bool wide, std::uint64_t first) const {
  Header header{wide, "CDF"};
  header.bytes.push_back(wide ? '\5' : '\2');
  header.count(0);  // records
  header.list(kDimensions, dimensions_.size());
  for (const Named& dimension : dimensions_) {
    header.text(dimension.name);
    header.count(dimension.length);
  }
  header.attributes(attributes_);
  header.list(kVariables, variables_.size());
  std::uint64_t end = first;  // variables of records begin behind all others, and have no byte here
  for (const Variable& variable : variables_)
    if (!variable.of_records) end += padded(variable.bytes);
  std::uint64_t begin = first;
  for (const Variable& variable : variables_) {
    header.text(variable.name);
    header.count(variable.dimensions.size());
    for (const std::size_t dimension : variable.dimensions) header.count(dimension);
    header.attributes(variable.attributes);
    header.tag(static_cast<std::int32_t>(variable.type));
    header.count(padded(variable.bytes));
    header.offset(variable.of_records ? end : begin);
    if (!variable.of_records) begin += padded(variable.bytes);
  }
  return header.bytes;
}

void NetcdfClassic::write(OutputFile& file) const {
  const bool wide = std::any_of(variables_.begin(), variables_.end(), [](const Variable& variable) {
    return padded(variable.bytes) > std::numeric_limits<std::uint32_t>::max();
  });
  file.write(header(wide, header(wide, 0).size()));
  for (const Variable& variable : variables_) {
    if (variable.of_records) continue;
    variable.write(file);
    file.write(std::string(padded(variable.bytes) - variable.bytes, '\0'));
  }
}

}  // namespace octet
