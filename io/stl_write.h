// SPDX-License-Identifier: BSD-3-Clause
// STL's format: the boundary alone.
#pragma once

#include "io/msh_write.h"
#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes the triangles on model faces, each once. Those with tetrahedra on one side alone are turned out of
/// these, others as their face is. ASCII has a `solid` for every face, by its name made as for INP files;
/// binary has no names, and keeps coordinates in single precision. `scale` multiplies coordinates.
/// OutputError for meshes of second order, which a file of flat triangles cannot hold, and for more than
/// 4294967295 triangles. [STL]
void write_stl(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
               double scale);

}  // namespace octet
