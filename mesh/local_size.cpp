// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at its vertices, told from the mesh itself.
#include "mesh/local_size.h"

#include <algorithm>

#include "mesh/tet_mesh.h"

namespace octet {

std::vector<std::array<Mesh::Index, 2>> tet_edges(const Mesh& mesh) {
  // Buckets by the smaller end: few entries each.
  std::vector<std::size_t> start(mesh.points.size() + 1, 0);
  const auto for_each_edge = [&](auto&& visit) {
    for (const auto& v : mesh.tets) {
      for (const auto& e : kTetEdge) visit(std::min(v[e[0]], v[e[1]]), std::max(v[e[0]], v[e[1]]));
    }
  };
  for_each_edge([&](Mesh::Index lo, Mesh::Index) { ++start[lo + 1]; });
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<Mesh::Index> far(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_each_edge([&](Mesh::Index lo, Mesh::Index hi) { far[next[lo]++] = hi; });
  std::vector<std::array<Mesh::Index, 2>> edges;
  edges.reserve(2 * mesh.tets.size());
  for (Mesh::Index v = 0; v + 1 < start.size(); ++v) {
    const auto begin = far.begin() + static_cast<std::ptrdiff_t>(start[v]);
    auto end = far.begin() + static_cast<std::ptrdiff_t>(start[v + 1]);
    std::sort(begin, end);
    end = std::unique(begin, end);
    for (auto w = begin; w != end; ++w) edges.push_back({v, *w});
  }
  return edges;
}

std::vector<double> vertex_sizes(const Mesh& mesh, const std::vector<std::array<Mesh::Index, 2>>& edges) {
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
