// SPDX-License-Identifier: BSD-3-Clause
// Bulk data of Nastran. [Nastran, "Bulk Data Entries"]
#pragma once

#include <string>

#include "io/output_file.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Bulk data to be included in a deck, behind its BEGIN BULK (INCLUDE 'part.bdf'), in fixed fields: GRID* for
/// the nodes; CTETRA of four or ten nodes, whose property is their region's tag; for each region a PSOLID
/// whose material has its number (the deck has the MAT1); for each face, edge and vertex a SET1 of the nodes
/// on it, its ends and borders among them, numbered on from the faces' tags; for each face a load set of its
/// tag with PLOAD4 of unit pressure on its sides, of an interface the sides in the region that the face's
/// normal points out of, for the deck's LOAD to scale. Comments before each tell the entity and its name.
/// Nodes and elements count from 1 in the mesh's order.
///
/// OutputError when there are more than 99 999 999 nodes or elements: fields have eight characters.
void write_bdf(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale);

/// A real number in sixteen characters, a blank first, with a point and as many digits as that leaves.
[[nodiscard]] std::string wide_field(double x);

}  // namespace octet
