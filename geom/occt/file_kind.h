// SPDX-License-Identifier: BSD-3-Clause
// Which CAD format a file holds, told by its content.
#pragma once

#include <filesystem>

namespace octet {

enum class FileKind { kStep, kIges, kBrep };

/// InputError, one line: missing, a directory, unreadable, empty, not a CAD file.
[[nodiscard]] FileKind file_kind(const std::filesystem::path& path);

}  // namespace octet
