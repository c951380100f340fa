// SPDX-License-Identifier: BSD-3-Clause
// Files of groups, attributes and arrays, by the HDF5 library.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "io/output_file.h"

namespace octet {

/// InputError, with what to do, when HDF5 files cannot be written: this build has no HDF5, or its library
/// cannot be loaded. The library is loaded when it is first asked for: with what it needs in turn it is
/// 36 libraries, which no other run should wait for.
void check_hdf5();

/// Writes one file. HDF5 keeps its state for the whole process, so only one file is open at a time: others
/// wait in the constructor. Same calls, same bytes. Each function throws OutputError with HDF5's reason.
class Hdf5File {
 public:
  /// Takes the place of what `file` writes to, into which nothing may be written besides; its commit() comes
  /// after close(). OutputError when that is a pipe or a device, in which HDF5 cannot go back.
  /// `order`: which order of a group's members the file keeps.
  enum class Order { kOfNames, kAsMade };
  explicit Hdf5File(const OutputFile& file, Order order = Order::kOfNames);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Makes a group; the one that it is in is there.
  void group(const std::string& path);
  void attribute(const std::string& path, const char* name, std::int32_t value);
  void attribute(const std::string& path, const char* name, double value);
  /// As an array of one.
  void attribute_array(const std::string& path, const char* name, std::int32_t value);
  /// Of so many bytes besides the zero that ends it, or as long as the text is.
  void attribute(const std::string& path, const char* name, const std::string& text, std::size_t length = 0);

  /// An array of int8_t, int32_t, float or double, of one dimension or two; value(i) is its element i,
  /// counted as they lie in the file, and is asked in parallel. Large arrays are made and written in parts.
  template <class T, class Value>
  void array(const std::string& path, const std::vector<std::uint64_t>& dims, const Value& value);
  /// Texts of `width` bytes each, as arrays of int8_t, zeros behind.
  void texts(const std::string& path, const std::vector<std::string>& texts, std::size_t width);

  /// Whole when this returns. Nothing may be written afterwards.
  void close();

 private:
  enum class Kind { kInt8, kInt32, kFloat, kDouble };
  static Kind kind_of(std::int8_t) { return Kind::kInt8; }
  static Kind kind_of(std::int32_t) { return Kind::kInt32; }
  static Kind kind_of(float) { return Kind::kFloat; }
  static Kind kind_of(double) { return Kind::kDouble; }

  void begin_array(const std::string& path, Kind kind, const std::vector<std::uint64_t>& dims);
  /// Elements [first, first + count) of an array of one dimension, rows of one of two.
  void put(std::uint64_t first, std::uint64_t count, const void* values);
  void end_array();
  void put_attribute(const std::string& path, const char* name, std::int64_t type, const void* value,
                     bool as_array = false);

  [[noreturn]] void fail(const char* function, int error) const;

  std::unique_lock<std::mutex> alone_;
  std::string named_;
  Order order_;
  std::int64_t file_ = -1;  ///< HDF5's numbers of what is open, or -1
  std::int64_t array_ = -1;
  Kind kind_ = Kind::kInt32;
  std::vector<std::uint64_t> dims_;
};

template <class T, class Value>
void Hdf5File::array(const std::string& path, const std::vector<std::uint64_t>& dims, const Value& value) {
  constexpr std::uint64_t kPart = std::uint64_t{1} << 20, kGrain = 4096;
  const std::uint64_t row = dims.size() == 2 ? dims[1] : 1;
  const std::uint64_t rows = std::max<std::uint64_t>(1, kPart / row);
  begin_array(path, kind_of(T{}), dims);
  std::vector<T> values;
  for (std::uint64_t first = 0; first < dims[0]; first += rows) {
    const std::uint64_t last = std::min(dims[0], first + rows);
    values.resize((last - first) * row);
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(first * row, last * row, kGrain),
                      [&](const tbb::blocked_range<std::uint64_t>& range) {
                        for (std::uint64_t i = range.begin(); i < range.end(); ++i)
                          values[i - first * row] = value(i);
                      });
    put(first, last - first, values.data());
  }
  end_array();
}

}  // namespace octet
