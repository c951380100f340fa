// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at its vertices, told from the mesh itself.
#pragma once

#include <vector>

#include "mesh/edges.h"

namespace octet {

/// Per vertex the mean length of the edges at it, averaged twice over the neighbours, so that one bad element
/// does not set its own standard. Model units. `edges`: element_edges() of the mesh.
[[nodiscard]] std::vector<double> vertex_sizes(const Mesh& mesh, const std::vector<EdgeEnds>& edges);

}  // namespace octet
