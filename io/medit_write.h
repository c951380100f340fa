// SPDX-License-Identifier: BSD-3-Clause
// Medit's format: FreeFEM, mmg, and what libMeshb reads.
#pragma once

#include "io/msh_write.h"
#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes a mesh of either order as .mesh (kAscii) or .meshb (kBinary: version 2, which all readers take, up
/// to 2 GB, version 3 beyond). References are the tags of
/// regions, faces and edges, of a node those of the entity of least dimension that holds it; nodes on
/// model vertices are `Corners`. Names that the CAD gives stand in comments of the ASCII file, for the format
/// has none. `scale` multiplies coordinates. OutputError when the mesh has more nodes or elements of a kind
/// than 2147483647. [libMeshb]
void write_medit(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale);

}  // namespace octet
