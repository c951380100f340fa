// SPDX-License-Identifier: BSD-3-Clause
// Edges are sorted by their lower vertex, at which there are few: the number of one is found among those.
#include "mesh/mid_nodes.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "base/blocks.h"
#include "base/bucket_sort.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

using Index = Mesh::Index;
using Ends = std::array<Index, 2>;

Ends ascending(Index a, Index b) { return a < b ? Ends{a, b} : Ends{b, a}; }

/// The ends of the i-th side of an element, of all elements of all dimensions.
class Sides {
 public:
  explicit Sides(const Mesh& mesh) : mesh_(mesh) {}
  [[nodiscard]] std::size_t count() const {
    return of_tets() + 3 * mesh_.triangles.size() + mesh_.edges.size();
  }
  [[nodiscard]] Ends operator[](std::size_t i) const {
    if (i < of_tets()) {
      const auto& edge = kTetEdge[i % 6];
      const auto& tet = mesh_.tets[i / 6];
      return ascending(tet[static_cast<std::size_t>(edge[0])], tet[static_cast<std::size_t>(edge[1])]);
    }
    i -= of_tets();
    if (i < 3 * mesh_.triangles.size()) {
      const auto& triangle = mesh_.triangles[i / 3];
      return ascending(triangle[i % 3], triangle[(i + 1) % 3]);
    }
    const auto& edge = mesh_.edges[i - 3 * mesh_.triangles.size()];
    return ascending(edge[0], edge[1]);
  }

 private:
  [[nodiscard]] std::size_t of_tets() const { return 6 * mesh_.tets.size(); }
  const Mesh& mesh_;
};

/// Ends of all edges, ascending, each once.
std::vector<Ends> edges_of(const Mesh& mesh) {
  const Sides sides(mesh);
  const auto sorted = bucket_sorted(
      sides.count(), mesh.points.size(), [&](std::size_t i) { return sides[i]; },
      [](const Ends& ends) { return ends[0]; }, [](const Ends& a, const Ends& b) { return a[1] < b[1]; });
  return collect<Ends>(sides.count(), [&](std::size_t i, std::vector<Ends>& edges) {
    if (i == 0 || sorted[i] != sorted[i - 1]) edges.push_back(sorted[i]);
  });
}

/// The number of an edge by its vertices.
class EdgeNumbers {
 public:
  EdgeNumbers(const std::vector<Ends>& edges, std::size_t points) : edges_(edges), first_(points + 1, 0) {
    for (const Ends& ends : edges) ++first_[ends[0] + 1];
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
  }
  [[nodiscard]] Index of(Index a, Index b) const {
    const Ends ends = ascending(a, b);
    const auto begin = edges_.begin() + first_[ends[0]], end = edges_.begin() + first_[ends[0] + 1];
    const auto at = std::lower_bound(begin, end, ends);
    OCTET_CHECK(at != end && *at == ends);
    return static_cast<Index>(at - edges_.begin());
  }

 private:
  const std::vector<Ends>& edges_;
  std::vector<Index> first_;  ///< per vertex: the first edge whose lower end it is
};

/// What holds each edge: a later loop's entity is of less dimension.
void classify(const Mesh& mesh, MidNodes& mid) {
  mid.on.resize(mid.between.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index m : mid.of_tets[t]) mid.on[m] = model_region(mesh.tet_in[t]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index m : mid.of_triangles[t]) mid.on[m] = model_face(mesh.triangle_on[t]);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) mid.on[mid.of_edges[e]] = model_edge(mesh.edge_on[e]);
}

}  // namespace

MidNodes straight_mid_nodes(const Mesh& mesh) {
  MidNodes mid;
  mid.between = edges_of(mesh);
  if (mid.between.size() + mesh.points.size() > std::numeric_limits<Index>::max())
    throw LimitError("a mesh of second order would have more nodes than there are numbers for");
  const EdgeNumbers numbers(mid.between, mesh.points.size());
  mid.points.resize(mid.between.size());
  tbb::parallel_for(std::size_t{0}, mid.between.size(), [&](std::size_t m) {
    mid.points[m] = 0.5 * (mesh.points[mid.between[m][0]] + mesh.points[mid.between[m][1]]);
  });
  mid.of_tets.resize(mesh.tets.size());
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    const auto& tet = mesh.tets[t];
    for (std::size_t e = 0; e < 6; ++e)
      mid.of_tets[t][e] = numbers.of(tet[static_cast<std::size_t>(kTetEdge[e][0])],
                                     tet[static_cast<std::size_t>(kTetEdge[e][1])]);
  });
  mid.of_triangles.resize(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, mesh.triangles.size(), [&](std::size_t t) {
    const auto& v = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) mid.of_triangles[t][k] = numbers.of(v[k], v[(k + 1) % 3]);
  });
  for (const auto& edge : mesh.edges) mid.of_edges.push_back(numbers.of(edge[0], edge[1]));
  classify(mesh, mid);
  return mid;
}

}  // namespace octet
