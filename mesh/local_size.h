// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at its vertices, told from the mesh itself.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// The edges of the tetrahedra, once each, both ends ascending, sorted. O(tetrahedra).
[[nodiscard]] std::vector<std::array<Mesh::Index, 2>> tet_edges(const Mesh& mesh);

/// Per vertex the mean length of the edges at it, averaged twice over the neighbours, so that one bad element
/// does not set its own standard. Model units.
[[nodiscard]] std::vector<double> vertex_sizes(const Mesh& mesh,
                                               const std::vector<std::array<Mesh::Index, 2>>& edges);

}  // namespace octet
