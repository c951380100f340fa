// SPDX-License-Identifier: BSD-3-Clause
// Which faces a mesh must have at each model edge and vertex.
#include "classify/expected_faces.h"

#include <algorithm>
#include <numeric>

namespace octet {
namespace {

bool has_edge(const Model& model, int vertex, int face) {
  const auto& edges = model.vertex(vertex).edges;
  return std::any_of(edges.begin(), edges.end(), [&](int e) {
    const ModelEdge& edge = model.edge(e);
    return edge.use == EdgeUse::kReal && std::binary_search(edge.faces.begin(), edge.faces.end(), face);
  });
}

}  // namespace

ExpectedFaces::ExpectedFaces(const Model& model)
    : end_(static_cast<std::size_t>(model.count(1)) + 2, 0),
      edgeless_(static_cast<std::size_t>(model.count(0)) + 1, 0) {
  const auto for_each_side = [&](const auto& visit) {
    for (int f = 1; f <= model.count(2); ++f) {
      if (model.is_outside(f)) continue;
      for (const FaceBoundary& side : model.face(f).boundary) visit(static_cast<std::size_t>(side.edge), f);
    }
  };
  for_each_side([&](std::size_t edge, int) { ++end_[edge + 1]; });
  std::partial_sum(end_.begin(), end_.end(), end_.begin());
  faces_.resize(end_.back());
  for_each_side([&](std::size_t edge, int f) { faces_[end_[edge]++] = f; });
  for (int f = 1; f <= model.count(2); ++f) {
    if (model.is_outside(f)) continue;
    for (const int v : model.face(f).vertices)
      if (!has_edge(model, v, f)) ++edgeless_[static_cast<std::size_t>(v)];
  }
}

std::span<const int> ExpectedFaces::at_edge(int edge) const {
  const auto e = static_cast<std::size_t>(edge);
  return std::span(faces_).subspan(end_[e - 1], end_[e] - end_[e - 1]);
}

}  // namespace octet
