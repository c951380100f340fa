// SPDX-License-Identifier: BSD-3-Clause
// Files that say which sizes are wanted where.
#pragma once

#include <filesystem>

#include "mesh/background.h"

namespace octet {

/// A CSV file with four numbers a line, x, y, z, size: a point cloud. With one number a line: the sizes of
/// the tetrahedra of `mesh` (an MSH or VTU file) in its order, or of its nodes, whichever are as many. An MSH
/// file with one ASCII view ($ElementData or $NodeData): sizes on its own mesh. Lines of a CSV file that do
/// not begin with a number are comments. InputError when there is nothing of that kind, or no positive size.
[[nodiscard]] Background read_size_file(const std::filesystem::path& path,
                                        const std::filesystem::path& mesh = {});

}  // namespace octet
