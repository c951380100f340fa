// SPDX-License-Identifier: BSD-3-Clause
// MED's format: SALOME and code_aster.
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes a mesh of either order. Every region, face and edge is a group of its elements, every model vertex
/// one of its node, each in a family of its own, by names made as for INP files, of 24 characters at most,
/// which is what code_aster takes. Corners of tetrahedra and their middles are in MED's order, whose
/// tetrahedra are turned the other way round. `scale` multiplies coordinates. The file says that it is of
/// version 3.0, which later libraries read, too. InputError as check_hdf5(); OutputError when the mesh has
/// more than 2147483647 nodes or elements of a kind. [MED]
void write_med(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
