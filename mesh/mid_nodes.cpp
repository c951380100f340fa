// SPDX-License-Identifier: BSD-3-Clause
// The number of an edge is found among the few that have its lower vertex.
#include "mesh/mid_nodes.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "base/error.h"
#include "mesh/edges.h"

namespace octet {
namespace {

using Index = Mesh::Index;
/// The number of an edge by its vertices.
class EdgeNumbers {
 public:
  EdgeNumbers(const std::vector<EdgeEnds>& edges, std::size_t points) : edges_(edges), first_(points + 1, 0) {
    for (const EdgeEnds& ends : edges) ++first_[ends[0] + 1];
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
  }
  [[nodiscard]] Index of(const EdgeEnds& ends) const {
    const auto begin = edges_.begin() + first_[ends[0]], end = edges_.begin() + first_[ends[0] + 1];
    const auto at = std::lower_bound(begin, end, ends);
    OCTET_CHECK(at != end && *at == ends);
    return static_cast<Index>(at - edges_.begin());
  }

 private:
  const std::vector<EdgeEnds>& edges_;
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
  mid.between = element_edges(mesh);
  if (mid.between.size() + mesh.points.size() > std::numeric_limits<Index>::max())
    throw LimitError("a mesh of second order would have more nodes than there are numbers for");
  const EdgeNumbers numbers(mid.between, mesh.points.size());
  mid.points.resize(mid.between.size());
  tbb::parallel_for(std::size_t{0}, mid.between.size(),
                    [&](std::size_t m) { mid.points[m] = middle_of(mesh, mid.between[m]); });
  mid.of_tets.resize(mesh.tets.size());
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    for (std::size_t e = 0; e < 6; ++e) mid.of_tets[t][e] = numbers.of(tet_edge(mesh, t, e));
  });
  mid.of_triangles.resize(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, mesh.triangles.size(), [&](std::size_t t) {
    const auto& v = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) mid.of_triangles[t][k] = numbers.of(edge_ends(v[k], v[(k + 1) % 3]));
  });
  for (const auto& edge : mesh.edges) mid.of_edges.push_back(numbers.of(edge_ends(edge[0], edge[1])));
  classify(mesh, mid);
  return mid;
}

}  // namespace octet
