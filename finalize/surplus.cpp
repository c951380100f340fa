// SPDX-License-Identifier: BSD-3-Clause
// One collapse each.
#include "finalize/surplus.h"

#include <algorithm>
#include <vector>

#include "base/sort_unique.h"
#include "finalize/collapse.h"

namespace octet {
namespace {

/// The neighbours of a vertex on its model edge, ascending.
std::vector<VertexId> neighbours_on_edge(const WorkMesh& mesh, VertexId v, const std::vector<TetId>& tets) {
  std::vector<VertexId> found;
  for (const TetId t : tets)
    for (const VertexId w : mesh.tets[t])
      if (w != v && piece_on(mesh, v, w) != 0) found.push_back(w);
  sort_unique(found);
  return found;
}

}  // namespace

void draw_in(Mesh& mesh, const Model& model, const FinalizeOptions& options,
             std::span<const Mesh::Index> surplus) {
  /// Of the worst shape: finalization comes after, and makes it good.
  constexpr double kShareOfWorst = 0.02;
  if (surplus.empty()) return;
  Workshop shop(mesh, model, options);
  std::vector<TetId> tets;
  bool any = false;
  for (const Mesh::Index index : surplus) {
    const VertexId gone(index);
    star(shop.mesh, gone, tets);
    double worst = 1.0;
    for (const TetId t : tets) worst = std::min(worst, shop.mesh.quality[t]);
    const std::vector<VertexId> others = neighbours_on_edge(shop.mesh, gone, tets);
    any =
        std::any_of(others.begin(), others.end(),
                    [&](VertexId kept) { return collapse_edge(shop, gone, kept, kShareOfWorst * worst); }) ||
        any;
  }
  if (any) mesh = to_mesh(shop.mesh);
}

}  // namespace octet
