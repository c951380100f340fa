// SPDX-License-Identifier: BSD-3-Clause
// The Gmsh formats. [Gmsh reference manual, "MSH file format", versions 4.1 and 2.2]
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

enum class Encoding { kAscii, kBinary };

/// Node and element tags run from 1; node tag i + 1 is point i; nodes and elements stand in blocks per model
/// entity. Elements are the nodes on model vertices, then edges, triangles and tetrahedra.
void write_msh41(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale);
/// The same tags; the physical and the elementary tag of an element are its model entity.
void write_msh22(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale);

}  // namespace octet
