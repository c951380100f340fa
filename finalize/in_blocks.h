// SPDX-License-Identifier: BSD-3-Clause
// Finalization of large meshes in blocks, side by side.
#pragma once

#include <optional>

#include "finalize/finalize.h"

namespace octet {

/// As finalize(), in blocks that do not depend on the number of threads: the smallest of `block_tets`, twice
/// as many, ... that have little of the mesh about their seams. None, and nothing done, where there are no
/// two of them.
std::optional<FinalizeReport> finalize_in_blocks(Mesh& mesh, const Model& model,
                                                 const FinalizeOptions& options, Observer& observer);

}  // namespace octet
