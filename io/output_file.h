// SPDX-License-Identifier: BSD-3-Clause
// A file that appears under its name only when it is whole.
#pragma once

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace octet {

/// What most writers make of the text of in one task: OutputFile::write_blocks().
inline constexpr std::size_t kItemsATask = 16384;

/// Writes to a temporary name beside the target; commit() renames. Every failure is an OutputError that
/// names the target and the reason, and leaves no temporary file and the old target, if any, as it was.
/// A target that is a device or a pipe is written directly.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// The value's bytes, as the machine keeps them.
  template <class T>
  void put(const T& value) {
    write(&value, sizeof value);
  }
  /// Writes what fill(first, last, bytes) appends for blocks of `block` items of [0, n), in their order; the
  /// filling runs in parallel.
  template <class Fill>
  void write_blocks(std::size_t n, std::size_t block, const Fill& fill);
  /// The target as it was given, for messages.
  [[nodiscard]] const std::filesystem::path& named() const { return named_; }
  /// Where what is written stands until commit(); empty when it goes to a device or a pipe.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  /// Flushes, closes and renames. Nothing may be written afterwards.
  void commit();

 private:
  void open_beside_target();
  void flush();
  [[noreturn]] void fail(const char* what, int error) const;

  std::filesystem::path named_;      ///< as the user gave it, for messages
  std::filesystem::path target_;     ///< links resolved
  std::filesystem::path temporary_;  ///< empty once renamed, or when written directly
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

template <class Fill>
void OutputFile::write_blocks(std::size_t n, std::size_t block, const Fill& fill) {
  constexpr std::size_t kInFlight = 16;  // bounds the memory, and is the same for any number of threads
  // A block's bytes stay here: a pipeline that an exception ends frees no values on their way. Blocks leave
  // in order, so that the one kInFlight before has left when a block comes in.
  std::array<std::string, kInFlight> bytes;
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& flow) {
    if (next >= n) flow.stop();
    const std::size_t first = next;
    next += block;
    return first;
  };
  const auto format = [&](std::size_t first) {
    std::string& here = bytes[first / block % kInFlight];
    here.clear();
    fill(first, std::min(n, first + block), here);
    return first;
  };
  const auto put = [&](std::size_t first) { write(bytes[first / block % kInFlight]); };
  tbb::parallel_pipeline(kInFlight,
                         tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, format) &
                             tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, put));
}

}  // namespace octet
