// SPDX-License-Identifier: BSD-3-Clause
// Classified meshes from VTU: with the arrays entity_dim and entity_tag, as vtu_write makes them.
#pragma once

#include <string_view>

#include "io/raw_mesh.h"

namespace octet {

/// InputError when the bytes are no such file.
[[nodiscard]] RawMesh read_vtu(std::string_view bytes);

}  // namespace octet
