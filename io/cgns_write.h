// SPDX-License-Identifier: BSD-3-Clause
// CGNS' format, in HDF5: solvers of flows.
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Writes a mesh of either order: one base with one zone of all nodes, in which every region is a section of
/// tetrahedra and every face one of triangles, turned as the face is, with a boundary condition of the same
/// name over them, whose type the family of that name is to give. Groups of faces are families, too, further
/// ones of their conditions. Names are made as for INP files, of 32 characters at most, which is the format's
/// own limit; model edges and vertices, which solvers of flows do not read, are left out. `scale` multiplies
/// coordinates. The file says that it is of version 3.1. InputError as check_hdf5(); OutputError when the
/// mesh has more than 2147483647 nodes or elements, or an array would be as long. [CGNS]
void write_cgns(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
