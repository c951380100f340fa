// SPDX-License-Identifier: BSD-3-Clause
// Runs the built program as its users do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace octet {

struct ProgramRun {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out, err;
  double seconds = 0.0;
};

struct ProgramLimits {
  long file_bytes = 0;  ///< no file may grow beyond it; 0: no limit
};

/// Runs `octet` with these arguments; waits for its end.
[[nodiscard]] ProgramRun run_octet(const std::vector<std::string>& arguments,
                                   const ProgramLimits& limits = {});

/// A directory that is empty at first and gone at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Names of what lies in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const std::string& bytes);
/// A file of models/.
[[nodiscard]] std::string model_file(const std::string& name);

}  // namespace octet
