// SPDX-License-Identifier: BSD-3-Clause
// SU2's native format. [SU2, "Mesh File"]
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes tetrahedra, nodes, and a marker by its name for each face, its triangles turned outwards. Several
/// regions are a zone each, in the order of their tags, with nodes of their own; faces between two are
/// markers of both. Faces within a region, edges and vertices are not in the file: markers are where a zone
/// ends. `scale` multiplies coordinates.
/// OutputError for a mesh of second order, which the format lacks.
void write_su2(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
