// SPDX-License-Identifier: BSD-3-Clause
// The universal file of I-DEAS, which FreeCAD, Salome, Code_Aster, Elmer and OpenFOAM read.
// [UNV, datasets 2411, 2412, 2467]
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Datasets 2411 (nodes), 2412 (beams 21 or 24 on model edges, thin shells 91 or 92 on faces, solids 111 or
/// 118) and 2467: for each region, face and edge a group of its elements, for each vertex one of its node, by
/// the names of io/set_names.h, of 40 characters at most. Nodes and elements count from 1, elements of edges
/// first, then those of faces and regions, each in the mesh's order. The property and material of an element
/// is its entity's tag. There is no dataset of units: lengths are in the unit asked for.
///
/// OutputError when there are more than 999 999 999 nodes or elements: longer numbers leave no blank between
/// two of them.
void write_unv(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
