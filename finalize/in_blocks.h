// SPDX-License-Identifier: BSD-3-Clause
// Finalization of large meshes in blocks, side by side.
#pragma once

#include <optional>

#include "finalize/finalize.h"

namespace octet {

/// As finalize(), in blocks that do not depend on the number of threads. None, and nothing done, where the
/// mesh is too small for that, or as deep as it is wide, so that most of it lies about the blocks' seams.
std::optional<FinalizeReport> finalize_in_blocks(Mesh& mesh, const Model& model,
                                                 const FinalizeOptions& options, Observer& observer);

}  // namespace octet
