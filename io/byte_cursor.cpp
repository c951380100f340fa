// SPDX-License-Identifier: BSD-3-Clause
// from_chars: no locale, no allocation, exact.
#include "io/byte_cursor.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"

namespace octet {
namespace {

bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

template <class T>
T number(ByteCursor& cursor, const char* what) {
  std::string_view text = cursor.word();
  if (text.size() > 1 && text[0] == '+') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    cursor.fail(fmt::format("{} is expected, not \"{}\"", what, text.substr(0, 40)));
  return value;
}

}  // namespace

void ByteCursor::skip_blanks() {
  while (at_ < bytes_.size() && blank(bytes_[at_])) ++at_;
}

bool ByteCursor::at_end() {
  skip_blanks();
  return at_ == bytes_.size();
}

std::string_view ByteCursor::word() {
  skip_blanks();
  const std::size_t start = at_;
  while (at_ < bytes_.size() && !blank(bytes_[at_])) ++at_;
  return bytes_.substr(start, at_ - start);
}

std::string_view ByteCursor::line() {
  const std::size_t start = at_;
  const std::size_t end = bytes_.find('\n', at_);
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  std::string_view text = bytes_.substr(start, (end == std::string_view::npos ? at_ : end) - start);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

bool ByteCursor::skip_past(std::string_view text) {
  const std::size_t found = bytes_.find(text, at_);
  if (found == std::string_view::npos) return false;
  at_ = found + text.size();
  return true;
}

std::int64_t ByteCursor::integer() { return number<std::int64_t>(*this, "an integer"); }

double ByteCursor::real() { return number<double>(*this, "a number"); }

std::string_view ByteCursor::take(std::size_t count) {
  if (count > left()) fail("the file ends too early");
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

std::size_t ByteCursor::checked_count(std::uint64_t count, std::size_t least_bytes, const char* what) const {
  if (count > left() / least_bytes)
    fail(fmt::format("{} {} are announced, more than the file can hold", count, what));
  return static_cast<std::size_t>(count);
}

void ByteCursor::fail(const std::string& what) const {
  throw InputError(fmt::format("{} (at byte {})", what, at_));
}

}  // namespace octet
