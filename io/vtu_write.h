// SPDX-License-Identifier: BSD-3-Clause
// VTK's XML format for unstructured grids.
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"

namespace octet {

/// Appended raw data, connectivity and offsets in 32 bits while they fit. Cells: nodes on model vertices, edges, triangles,
/// tetrahedra. Cell data entity_dim, entity_tag and region (0 but for tetrahedra); point data entity_dim and
/// entity_tag.
void write_vtu(OutputFile& file, const Mesh& mesh, double scale);

}  // namespace octet
