// SPDX-License-Identifier: BSD-3-Clause
// Edges and vertices whose measured gaps are a danger to a mesh.
#include "geom/wide_gaps.h"

#include <algorithm>

namespace octet {

std::vector<WideGap> wide_gaps(const Model& model, double size) {
  std::vector<WideGap> gaps;
  const auto look = [&](const WideGap& gap) {
    if (gap.gap > kWideGapShare * gap.local) gaps.push_back(gap);
  };
  std::vector<double> shortest(static_cast<std::size_t>(model.count(0)) + 1, size);
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.use == EdgeUse::kDegenerate) continue;
    const double local = std::min(size, edge.length);
    for (const int v : edge.vertex) shortest[v] = std::min(shortest[v], local);
    look({model_edge(e), edge.tolerance, local, model.edge_point(e, 0.5 * (edge.t0 + edge.t1))});
  }
  for (int v = 1; v <= model.count(0); ++v)
    look({model_vertex(v), model.vertex(v).tolerance, shortest[v], model.vertex(v).point});
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const WideGap& a, const WideGap& b) { return a.gap * b.local > b.gap * a.local; });
  return gaps;
}

}  // namespace octet
