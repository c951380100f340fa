// SPDX-License-Identifier: BSD-3-Clause
// Medit's format: FreeFEM, mmg, and what libMeshb reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "io/msh_write.h"
#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes a mesh of either order as .mesh (kAscii) or .meshb (kBinary). References are the tags of regions,
/// faces and edges, of a node that of the entity of least dimension that holds it; nodes on model vertices
/// are `Corners`. Names that the CAD gives stand in comments of the ASCII file, for the format has none.
/// `scale` multiplies coordinates. A binary file is of version 2, which all readers take, unless it may have
/// more than `most_narrow` bytes: then of version 3, whose places in the file have eight bytes.
/// OutputError when the mesh has more than 2147483647 nodes or elements of a kind. [libMeshb]
void write_medit(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale, std::size_t most_narrow = std::numeric_limits<std::int32_t>::max());

}  // namespace octet
