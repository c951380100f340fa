// SPDX-License-Identifier: BSD-3-Clause
// MSH 4.1 and 2.2, ASCII and binary, of any writer.
#pragma once

#include <string_view>

#include "io/raw_mesh.h"

namespace octet {

/// Linear points, lines, triangles and tetrahedra; InputError for any other element, other versions, and
/// bytes that are no MSH file. Sections that a mesh does not need are skipped. Binary files of either byte
/// order. Views of nodes, elements and elements' nodes are read, too; `views_suffice`: a file of views
/// without nodes and elements will do.
[[nodiscard]] RawMesh read_msh(std::string_view bytes, bool views_suffice = false);

}  // namespace octet
