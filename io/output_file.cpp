// SPDX-License-Identifier: BSD-3-Clause
// Plain C streams: they tell the reason of a failure (errno) at each step, the close included.
#include "io/output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/error.h"

namespace octet {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20;
/// What is written without being gathered first.
constexpr std::size_t kLarge = std::size_t{1} << 16;
constexpr int kNamesTried = 1000;

/// What links lead to, whether it is there or not.
std::filesystem::path end_of_links(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, error); ++i) {
    const auto next = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;
  }
  return path;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : named_(target), target_(target) {
  if (target.empty()) throw OutputError("no output path is given");
  std::error_code error;
  target_ = end_of_links(target_);
  const auto status = std::filesystem::status(target_, error);
  if (std::filesystem::is_directory(status)) fail("it is a directory", 0);
  buffer_.reserve(kBufferSize);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    file_ = std::fopen(target_.string().c_str(), "wbe");
    if (file_ == nullptr) fail("it cannot be opened", errno);
  } else {
    open_beside_target();
  }
  std::setvbuf(file_, nullptr, _IONBF, 0);
}

void OutputFile::open_beside_target() {
  // The mode "e" keeps the file from programs that the host starts; "x" fails when the name exists: two runs,
  // or the remains of a killed one, cannot collide.
  for (int i = 0; i < kNamesTried; ++i) {
    auto name = target_;
    name += fmt::format(".part{}", i);
    file_ = std::fopen(name.string().c_str(), "wbxe");
    if (file_ != nullptr) {
      temporary_ = name;
      return;
    }
    if (errno != EEXIST) break;
  }
  fail("no file can be made beside it", errno);
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  if (count >= kLarge || buffer_.size() + count > kBufferSize) flush();
  if (count < kLarge) {
    buffer_.append(static_cast<const char*>(bytes), count);
  } else if (std::fwrite(bytes, 1, count, file_) != count) {
    fail("writing failed", errno);
  }
}

void OutputFile::flush() {
  if (!buffer_.empty() && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size())
    fail("writing failed", errno);
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  std::FILE* file = file_;
  file_ = nullptr;
  const bool flushed = std::fflush(file) == 0;
  const int flush_error = errno;
  if (std::fclose(file) != 0 || !flushed) fail("writing failed", flushed ? errno : flush_error);
  if (temporary_.empty()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) fail("the finished file cannot be given its name", error.value());
  temporary_.clear();
}

void OutputFile::fail(const char* what, int error) const {
  const std::string reason =
      error == 0 ? std::string() : fmt::format(" ({})", std::generic_category().message(error));
  throw OutputError(fmt::format("cannot write \"{}\": {}{}", named_.string(), what, reason));
}

}  // namespace octet
