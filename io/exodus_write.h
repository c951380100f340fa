// SPDX-License-Identifier: BSD-3-Clause
// Exodus II: what Sandia's codes, MOOSE, libMesh, Cubit and ParaView read. [Exodus]
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// An element block (TETRA or TETRA10) for each region, whose number is its tag; a side set for each face,
/// whose number is its tag, and on an interface of the sides of the region that its normal points out of; a
/// node set for each face, of the same number, edge and vertex, numbered on in this order. Their names are
/// those of io/set_names.h, of 32 characters at most: more some readers cut off. Elements are numbered block
/// by block; where that is not the mesh's own order, `elem_num_map` has the mesh's numbers, from 1. The file
/// is netCDF of the classic form with offsets of 64 bits, and holds no time and no date: same mesh, same
/// bytes.
///
/// OutputError when there are more than 2 147 483 647 nodes or elements.
void write_exodus(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
