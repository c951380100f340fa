// SPDX-License-Identifier: BSD-3-Clause
// A probe file in the output's own directory meets the very obstacles that the mesh would meet later.
#include "app/output_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "base/error.h"
#include "io/output_file.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw OutputError(fmt::format("cannot write \"{}\": {}", path.string(), reason));
}

std::string system_message(int error) { return std::generic_category().message(error); }

void check_directory(const fs::path& path) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  const fs::file_status status = fs::status(parent, error);
  if (!fs::exists(status)) refuse(path, fmt::format("the directory \"{}\" does not exist", parent.string()));
  if (!fs::is_directory(status)) refuse(path, fmt::format("\"{}\" is not a directory", parent.string()));
  const fs::space_info space = fs::space(parent, error);
  if (!error && space.capacity > 0 && space.available == 0) refuse(path, system_message(ENOSPC));
}

}  // namespace

void check_writable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) refuse(path, "it is a directory");
  if (path.empty() || !path.has_filename()) refuse(path, "it names no file");
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) refuse(path, system_message(errno));
  if (fs::exists(status) && !fs::is_regular_file(status)) return;  // a device or a pipe: written directly
  check_directory(path);
  const OutputFile probe(path);  // never committed: its destructor takes the temporary file away
}

void check_distinct(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (a == b || fs::equivalent(a, b, error))
    throw InputError(fmt::format("\"{}\" and \"{}\" are the same file", a.string(), b.string()));
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!fs::is_directory(path)) refuse(path, error ? error.message() : "it is not a directory");
}

}  // namespace octet
