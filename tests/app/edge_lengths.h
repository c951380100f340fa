// SPDX-License-Identifier: BSD-3-Clause
// Edge lengths of a mesh, of all of it or near a place.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace octet::test {

using MeshEdge = std::pair<Mesh::Index, Mesh::Index>;

/// Edges of these elements, each once.
template <std::size_t N>
std::vector<MeshEdge> edges_of(const std::vector<std::array<Mesh::Index, N>>& elements) {
  std::vector<MeshEdge> edges;
  for (const auto& element : elements)
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i + 1; j < N; ++j) edges.push_back(std::minmax(element[i], element[j]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Lengths of the edges that `chosen(ends)` accepts, ascending.
template <std::size_t N>
std::vector<double> edge_lengths(
    const Mesh& mesh, const std::vector<std::array<Mesh::Index, N>>& elements,
    const std::function<bool(const Vec3&, const Vec3&)>& chosen = [](const Vec3&, const Vec3&) {
      return true;
    }) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges_of(elements))
    if (chosen(mesh.points[a], mesh.points[b])) lengths.push_back((mesh.points[a] - mesh.points[b]).norm());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

inline double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

inline double median(const std::vector<double>& ascending) { return ascending[ascending.size() / 2]; }

/// Triangles on a model face.
inline std::vector<std::array<Mesh::Index, 3>> triangles_on(const Mesh& mesh, int face) {
  std::vector<std::array<Mesh::Index, 3>> chosen;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangle_on[i] == face) chosen.push_back(mesh.triangles[i]);
  return chosen;
}

/// Mesh edges on a model edge.
inline std::vector<std::array<Mesh::Index, 2>> edges_on(const Mesh& mesh, int edge) {
  std::vector<std::array<Mesh::Index, 2>> chosen;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    if (mesh.edge_on[i] == edge) chosen.push_back(mesh.edges[i]);
  return chosen;
}

}  // namespace octet::test
