// SPDX-License-Identifier: BSD-3-Clause
// Reading numbers from bytes that nobody vouches for.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace octet {

/// A position in a file's bytes. Every read that the bytes do not allow is an InputError that tells the
/// place; nothing is ever read past the end.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  void skip_blanks();
  /// Whether nothing but blanks is left.
  [[nodiscard]] bool at_end();
  /// The next word: up to a blank. Empty at the end.
  std::string_view word();
  /// The rest of the line, its end consumed and not returned.
  std::string_view line();
  /// Moves behind the next occurrence of the text; false (and no move) when there is none.
  bool skip_past(std::string_view text);

  std::int64_t integer();  ///< text
  double real();           ///< text
  /// The machine's bytes of a number, its byte order turned when `swap`.
  template <class T>
  T raw(bool swap) {
    char bytes[sizeof(T)];
    const std::string_view from = take(sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[swap ? sizeof(T) - 1 - i : i] = from[i];
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  std::string_view take(std::size_t count);
  /// A count of items each of which takes at least `least_bytes`: no larger than what is left can hold.
  [[nodiscard]] std::size_t checked_count(std::uint64_t count, std::size_t least_bytes,
                                          const char* what) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace octet
