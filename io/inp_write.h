// SPDX-License-Identifier: BSD-3-Clause
// The input format of Abaqus and CalculiX. [CalculiX, "Input deck format"]
#pragma once

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// A mesh to be included in a deck (*INCLUDE, INPUT=part.inp): *NODE; for each region its *ELEMENT of type
/// C3D4; for each face, edge and vertex an *NSET of the nodes on it, its ends and borders among them; for
/// each face a *SURFACE of element sides, for pressures and contact, of an interface the sides in the region
/// that the face's normal points out of. Nodes and elements count from 1 in the mesh's order.
///
/// A set is called as its entity, in letters, digits, _ and -, or else Solid1, Face12, Edge3, Vertex4; names
/// that differ in nothing else than upper and lower case get that behind them, for these programs tell
/// neither apart. OutputError when there are more than 2^31 - 1 nodes or elements.
void write_inp(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

}  // namespace octet
