// SPDX-License-Identifier: BSD-3-Clause
// Files that say which sizes are wanted where.
#pragma once

#include <filesystem>

#include "mesh/background.h"

namespace octet {

/// A CSV file with four numbers a line, x, y, z, size: a point cloud. With one number a line: the sizes of
/// the tetrahedra of `mesh` (an MSH or VTU file) in its order, or of its nodes, whichever are as many. Lines
/// before the first number may be a header, and lines that begin with # are comments; any other line that is
/// not such numbers is an error that tells it.
///
/// An MSH file with a view of scalars ($ElementData, $NodeData or $ElementNodeData; ASCII or binary) on its
/// own mesh, or else on `mesh` (an MSH file) by the tags of that. A VTU file with an array of real numbers on
/// its cells or points; where it has no tetrahedra, it is a cloud of its points, or of its cells' middles. Of
/// several views or arrays the one called "size" counts.
///
/// InputError when there is nothing of that kind, no positive size, or a place that is not finite.
[[nodiscard]] Background read_size_file(const std::filesystem::path& path,
                                        const std::filesystem::path& mesh = {});

}  // namespace octet
