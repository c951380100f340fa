// SPDX-License-Identifier: BSD-3-Clause
// VTK's XML format for unstructured grids.
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Appended raw data, connectivity and offsets in 32 bits while they fit. Cells: nodes on model vertices,
/// edges, triangles, tetrahedra. Cell data entity_dim, entity_tag and region (0 but for tetrahedra), and
/// colour (red, green, blue of 0..255, white where the CAD gives none) when the outline has any; point data
/// entity_dim and entity_tag. Field data, for what the outline gives: region_names, region_materials,
/// region_layers, face_names, ...: UTF-8 text as UInt8, one line per entity from tag 1 (VTK's own string
/// arrays stop other readers).
void write_vtu(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
