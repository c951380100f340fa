// SPDX-License-Identifier: BSD-3-Clause
// Vertices on model edges that there should not be.
#pragma once

#include <span>

#include "finalize/finalize.h"

namespace octet {

/// Draws each of these vertices, which are on model edges, onto a neighbour on its edge, where the model
/// allows it and no element gets far worse than the worst there: for a mesh that is to be finalized. The
/// first `fixed_vertices` keep their numbers, others need not.
void draw_in(Mesh& mesh, const Model& model, const FinalizeOptions& options,
             std::span<const Mesh::Index> surplus);

}  // namespace octet
