// SPDX-License-Identifier: BSD-3-Clause
// Files of arrays in the classic forms of netCDF, which need no library to write. [NetCDF]
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/output_file.h"

namespace octet {

/// What a file holds, declared first and written in one pass. Names are not tested for being new.
class NetcdfClassic {
 public:
  /// As the format numbers them.
  enum class Type : std::int32_t { kChar = 2, kInt = 4, kFloat = 5, kDouble = 6 };
  using Value = std::variant<std::string, std::int32_t, float>;
  using Attribute = std::pair<std::string, Value>;
  struct Dimension {
    std::size_t number = 0;
  };

  /// A dimension of at least one, for 0 stands for the dimension of records.
  Dimension dimension(const std::string& name, std::uint64_t length);
  /// The dimension that may grow; this file has none of its records.
  Dimension records(const std::string& name);
  void attribute(const std::string& name, Value value) { attributes_.emplace_back(name, std::move(value)); }
  /// `write` writes all values, in bytes as file_order() has them; nothing for a variable of records.
  void variable(const std::string& name, Type type, const std::vector<Dimension>& dimensions,
                std::function<void(OutputFile&)> write, std::vector<Attribute> attributes = {});

  /// Offsets of 64 bits; lengths, too, where a variable has 4 GiB and more. What a variable's writer puts out
  /// is taken for as many bytes as its dimensions say.
  void write(OutputFile& file) const;

 private:
  struct Named {
    std::string name;
    std::uint64_t length;
  };
  struct Variable {
    std::string name;
    Type type;
    std::vector<std::size_t> dimensions;
    std::vector<Attribute> attributes;
    std::function<void(OutputFile&)> write;
    bool of_records = false;
    std::uint64_t bytes = 0;  ///< of a record where it is one of records
  };
  [[nodiscard]] std::string header(bool wide, std::uint64_t first) const;

  std::vector<Named> dimensions_;
  std::vector<Attribute> attributes_;
  std::vector<Variable> variables_;
};

/// The value's bytes, highest first.
void append_file_order(std::string& bytes, std::int32_t value);
void append_file_order(std::string& bytes, float value);
void append_file_order(std::string& bytes, double value);

}  // namespace octet
