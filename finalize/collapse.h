// SPDX-License-Identifier: BSD-3-Clause
// Edge collapse: a vertex is drawn onto a neighbour, and what lay between them vanishes.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Draws `gone` onto `kept` if the worst shape of what changes is better than `floor`, the model allows it,
/// and the mesh stays a mesh.
///
/// Model: a model vertex stays; a vertex on an edge goes along a piece of that edge only, and a closed edge
/// keeps three pieces; a vertex on a face goes along an edge on that face only; a vertex in a region goes
/// anywhere. Mesh: the link condition, in the volume, on the faces and on the edges: what both ends know, the
/// edge knows.
bool collapse_edge(Workshop& shop, VertexId gone, VertexId kept, double floor);

/// The same where it also raises the sum of merits (finalize/mean_shape.h) and makes no edge much longer than
/// the local size.
bool collapse_edge_for_mean(Workshop& shop, VertexId gone, VertexId kept, double floor);

}  // namespace octet
