// SPDX-License-Identifier: BSD-3-Clause
// The edges of a mesh's elements: their ends, their middles, and a list of all.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/tet_mesh.h"

namespace octet {

/// The vertices of an edge, ascending.
using EdgeEnds = std::array<Mesh::Index, 2>;

[[nodiscard]] inline EdgeEnds edge_ends(Mesh::Index a, Mesh::Index b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Edge e of tetrahedron t, in the order of kTetEdge.
[[nodiscard]] inline EdgeEnds tet_edge(const Mesh& mesh, std::size_t t, std::size_t e) {
  const auto& tet = mesh.tets[t];
  return edge_ends(tet[static_cast<std::size_t>(kTetEdge[e][0])],
                   tet[static_cast<std::size_t>(kTetEdge[e][1])]);
}

/// The middle of the straight edge, to the bit the same wherever it is asked for.
[[nodiscard]] inline Vec3 middle_of(const Mesh& mesh, const EdgeEnds& ends) {
  return 0.5 * (mesh.points[ends[0]] + mesh.points[ends[1]]);
}

/// The edges of all elements, once each, sorted; of a sound mesh those of its tetrahedra. O(elements), in
/// parallel.
[[nodiscard]] std::vector<EdgeEnds> element_edges(const Mesh& mesh);

}  // namespace octet
