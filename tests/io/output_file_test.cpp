// SPDX-License-Identifier: BSD-3-Clause
// Files of a library belong to it alone.
#include "io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace octet {
namespace {

namespace fs = std::filesystem;

TEST(OutputFile, IsNotHandedToProgramsThatTheHostStarts) {
  const fs::path target = fs::temp_directory_path() / "octet_output_file_test";
  const OutputFile file(target);
  int open_files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    if (fs::read_symlink(entry.path(), gone).string().find(target.string()) != 0) continue;
    ++open_files;
    EXPECT_NE(::fcntl(std::stoi(entry.path().filename().string()), F_GETFD) & FD_CLOEXEC, 0);
  }
  EXPECT_EQ(open_files, 1);
}

}  // namespace
}  // namespace octet
