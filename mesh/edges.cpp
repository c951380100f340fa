// SPDX-License-Identifier: BSD-3-Clause
// The edges of all elements, by their lower vertex: few at each.
#include "mesh/edges.h"

#include "base/blocks.h"
#include "base/bucket_sort.h"

namespace octet {

std::vector<EdgeEnds> element_edges(const Mesh& mesh) {
  const std::size_t of_tets = 6 * mesh.tets.size(), of_triangles = 3 * mesh.triangles.size();
  const std::size_t count = of_tets + of_triangles + mesh.edges.size();
  const auto side = [&](std::size_t i) {
    if (i < of_tets) return tet_edge(mesh, i / 6, i % 6);
    i -= of_tets;
    if (i < of_triangles) {
      const auto& triangle = mesh.triangles[i / 3];
      return edge_ends(triangle[i % 3], triangle[(i + 1) % 3]);
    }
    const auto& edge = mesh.edges[i - of_triangles];
    return edge_ends(edge[0], edge[1]);
  };
  const auto sorted = bucket_sorted(
      count, mesh.points.size(), side, [](const EdgeEnds& ends) { return ends[0]; },
      [](const EdgeEnds& a, const EdgeEnds& b) { return a[1] < b[1]; });
  return collect<EdgeEnds>(count, [&](std::size_t i, std::vector<EdgeEnds>& edges) {
    if (i == 0 || sorted[i] != sorted[i - 1]) edges.push_back(sorted[i]);
  });
}

}  // namespace octet
