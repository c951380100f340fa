// SPDX-License-Identifier: BSD-3-Clause
// VTU as vtu_write makes it, appended and raw, or compressed by zlib; with the arrays entity_dim and
// entity_tag.
#pragma once

#include <string_view>

#include "io/raw_mesh.h"

namespace octet {

/// InputError when the bytes are no such file.
[[nodiscard]] RawMesh read_vtu(std::string_view bytes);

}  // namespace octet
