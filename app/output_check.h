// SPDX-License-Identifier: BSD-3-Clause
// Whether an output can be written, asked before the work and not after.
#pragma once

#include <filesystem>

namespace octet {

/// OutputError, one line, when no file can be made at `path`: no such directory, a directory, no permission,
/// a full disk. Leaves nothing behind.
void check_writable(const std::filesystem::path& path);

/// InputError when both are the same file.
void check_distinct(const std::filesystem::path& a, const std::filesystem::path& b);

/// Makes the directory when it is missing; OutputError when it cannot be made.
void make_directory(const std::filesystem::path& path);

}  // namespace octet
