// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at its vertices, told from the mesh itself.
#include "mesh/local_size.h"

#include <algorithm>

namespace octet {

std::vector<double> vertex_sizes(const Mesh& mesh, const std::vector<EdgeEnds>& edges) {
  constexpr int kAverages = 2;
  std::vector<double> size(mesh.points.size(), 0.0), sum(mesh.points.size(), 0.0);
  std::vector<int> count(mesh.points.size(), 0);
  for (const auto& [a, b] : edges) {
    const double length = (mesh.points[a] - mesh.points[b]).norm();
    sum[a] += length;
    sum[b] += length;
    ++count[a];
    ++count[b];
  }
  for (int pass = 0;; ++pass) {
    for (std::size_t v = 0; v < size.size(); ++v) size[v] = count[v] > 0 ? sum[v] / count[v] : 0.0;
    if (pass == kAverages) return size;
    std::fill(sum.begin(), sum.end(), 0.0);
    for (const auto& [a, b] : edges) {
      sum[a] += size[b];
      sum[b] += size[a];
    }
  }
}

}  // namespace octet
