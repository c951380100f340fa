// SPDX-License-Identifier: BSD-3-Clause
// A file that appears under its name only when it is whole.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace octet {

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

}  // namespace octet
