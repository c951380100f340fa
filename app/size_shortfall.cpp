// SPDX-License-Identifier: BSD-3-Clause
// Each side of a boundary triangle is looked at once.
#include "app/size_shortfall.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/bucket_sort.h"

namespace octet {
namespace {

void keep_worst(std::vector<ShortEdge>& edges) {
  std::stable_sort(edges.begin(), edges.end(), [](const ShortEdge& a, const ShortEdge& b) {
    return a.length * b.asked < b.length * a.asked;
  });
  if (edges.size() > kShortEdgesTold) edges.resize(kShortEdgesTold);
}

}  // namespace

void SizeShortfall::add(const SizeShortfall& other) {
  edges += other.edges;
  shortest.insert(shortest.end(), other.shortest.begin(), other.shortest.end());
  keep_worst(shortest);
}

SizeShortfall size_shortfall(const Mesh& mesh, const std::function<double(const Vec3&)>& size_at) {
  struct Side {
    Mesh::Index a, b;
    ModelRef on;
    [[nodiscard]] auto key() const { return std::tuple(a, b, on.dim, on.tag); }
  };
  std::vector<Side> sides;
  const auto add = [&](Mesh::Index a, Mesh::Index b, ModelRef on) {
    sides.push_back({std::min(a, b), std::max(a, b), on});
  };
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    add(mesh.edges[i][0], mesh.edges[i][1], model_edge(mesh.edge_on[i]));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      add(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3], model_face(mesh.triangle_on[i]));
  // Those on model edges come first among equals, and stand for all.
  bucket_sort(
      sides, mesh.points.size(), [](const Side& side) { return side.a; },
      [](const Side& x, const Side& y) { return x.key() < y.key(); });
  SizeShortfall result;
  std::map<std::pair<int, int>, ShortEdge> worst;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& [a, b, on] = sides[i];
    if (i > 0 && sides[i - 1].a == a && sides[i - 1].b == b) continue;
    const Vec3 middle = 0.5 * (mesh.points[a] + mesh.points[b]);
    const double length = (mesh.points[a] - mesh.points[b]).norm(), asked = size_at(middle);
    if (length >= kFarTooShort * asked) continue;
    ++result.edges;
    const auto [it, is_new] = worst.try_emplace({on.dim, on.tag}, ShortEdge{on, middle, length, asked});
    if (!is_new && length * it->second.asked < it->second.length * asked)
      it->second = {on, middle, length, asked};
  }
  for (const auto& [entity, edge] : worst) result.shortest.push_back(edge);
  keep_worst(result.shortest);
  return result;
}

}  // namespace octet
