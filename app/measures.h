// SPDX-License-Identifier: BSD-3-Clause
// What the report tells of a mesh beside its claims.
#pragma once

#include <string>

#include "app/mesh_part.h"
#include "finalize/finalize.h"

namespace octet {

/// Fills counts, shapes, volume and area of the mesh and of the CAD.
void measure_mesh(const Mesh& mesh, const Model& model, MeshReport& report);

/// One line.
[[nodiscard]] std::string describe(const FinalizeReport& report);

}  // namespace octet
