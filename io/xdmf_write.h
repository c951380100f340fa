// SPDX-License-Identifier: BSD-3-Clause
// XDMF's format with its arrays in a file of HDF5: DOLFINx and ParaView.
#pragma once

#include <string>

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes a mesh of either order: the XML to `file`, the arrays to `arrays`, which the XML calls
/// `arrays_name`. Grids: "mesh" (tetrahedra, with `region`), "faces" (triangles, with `face`), "edges" (with
/// `edge`) and "vertices" (with `vertex`), each with the tags of the model entities that its cells are on, so
/// that DOLFINx reads the first as a mesh and all as tags. Names that the CAD gives stand beside the grids.
/// Nodes are in VTK's order. `scale` multiplies coordinates. InputError as check_hdf5(); OutputError when the
/// mesh has more than 2147483647 nodes. [XDMF]
void write_xdmf(OutputFile& file, OutputFile& arrays, const std::string& arrays_name, const Mesh& mesh,
                const ModelOutline& outline, double scale);

}  // namespace octet
