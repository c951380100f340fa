// SPDX-License-Identifier: BSD-3-Clause
// What is asked for, what is held, and what came of it.
#include "app/edge_divisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "base/sort_unique.h"
#include "octree/equal_parts.h"

namespace octet {
namespace {

/// Per edge tag below `size`: how many mesh edges it has.
std::vector<int> pieces_on(const Mesh& mesh, std::size_t size) {
  std::vector<int> pieces(size, 0);
  for (const std::int32_t edge : mesh.edge_on)
    if (static_cast<std::size_t>(edge) < size) ++pieces[static_cast<std::size_t>(edge)];
  return pieces;
}

}  // namespace

std::vector<int> edge_divisions(const Model& model, const std::vector<SizeAttribute>& wishes) {
  std::vector<int> divisions;
  for (const SizeAttribute& wish : wishes) {
    if (wish.elements <= 0) continue;
    divisions.resize(static_cast<std::size_t>(model.count(1)) + 1, 0);
    for (const ModelRef edge : selected_entities(model, wish)) {
      int& most = divisions[static_cast<std::size_t>(edge.tag)];
      most = std::max(most, wish.elements);
    }
  }
  return divisions;
}

std::vector<Mesh::Index> with_divided(std::vector<Mesh::Index> held, const Mesh& mesh,
                                      const std::vector<int>& divisions) {
  if (divisions.empty()) return held;
  const std::vector<int> pieces = pieces_on(mesh, divisions.size());
  for (std::size_t v = 0; v < mesh.point_on.size(); ++v) {
    const ModelRef on = mesh.point_on[v];
    const auto edge = static_cast<std::size_t>(on.tag);
    if (on.dim == 1 && divisions[edge] > 0 && divisions[edge] == pieces[edge])
      held.push_back(static_cast<Mesh::Index>(v));
  }
  sort_unique(held);
  return held;
}

std::vector<Mesh::Index> surplus_vertices(const Mesh& mesh, const Model& model,
                                          const std::vector<int>& divisions) {
  constexpr double kAtPlace = 1e-3;  // of a piece: places are rounded, and no two vertices are as near
  std::vector<std::vector<Mesh::Index>> on(divisions.size());
  for (std::size_t v = 0; v < mesh.point_on.size() && !divisions.empty(); ++v)
    if (const ModelRef ref = mesh.point_on[v]; ref.dim == 1)
      on[static_cast<std::size_t>(ref.tag)].push_back(static_cast<Mesh::Index>(v));
  std::vector<Mesh::Index> surplus;
  for (std::size_t e = 1; e < divisions.size(); ++e) {
    const int n = divisions[e];
    if (n == 0 || on[e].size() < static_cast<std::size_t>(n)) continue;
    const int tag = static_cast<int>(e);
    std::vector<Mesh::Index> others = on[e];
    const double near = kAtPlace * model.edge(tag).length / n;
    for (const double t : equal_parts(model, tag, n)) {
      const Vec3 place = model.edge_point(tag, t);
      std::erase_if(others, [&](Mesh::Index v) { return (mesh.points[v] - place).norm() < near; });
    }
    if (on[e].size() - others.size() == static_cast<std::size_t>(n) - 1)
      surplus.insert(surplus.end(), others.begin(), others.end());
  }
  return surplus;
}

std::optional<std::string> note_of_divisions(const Mesh& mesh, const std::vector<int>& divisions) {
  constexpr int kTold = 5;
  const std::vector<int> pieces = pieces_on(mesh, divisions.size());
  std::string others;
  int count = 0;
  for (std::size_t e = 1; e < divisions.size(); ++e) {
    if (divisions[e] == 0 || pieces[e] == 0 || divisions[e] == pieces[e]) continue;
    if (count++ < kTold)
      others += fmt::format("{}Edge{} has {} ({})", others.empty() ? "" : ", ", e, pieces[e], divisions[e]);
  }
  if (count == 0) return std::nullopt;
  if (count > kTold) others += fmt::format(" and {} more", count - kTold);
  return "edges with another number of elements than asked for (in brackets), for smaller sizes about them, "
         "the user's or the part's own, or for holes that points on them close: " +
         others;
}

}  // namespace octet
