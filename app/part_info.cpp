// SPDX-License-Identifier: BSD-3-Clause
// Plain sums and extremes over the model's entities.
#include "app/part_info.h"

#include <algorithm>

#include "geom/sizing.h"

namespace octet {
namespace {

/// How often the boundaries of faces run along each edge.
std::vector<int> edge_uses(const Model& model) {
  std::vector<int> uses(static_cast<std::size_t>(model.count(1)) + 1, 0);
  for (int f = 1; f <= model.count(2); ++f)
    for (const FaceBoundary& side : model.face(f).boundary) ++uses[static_cast<std::size_t>(side.edge)];
  return uses;
}

void add_edges(const Model& model, PartInfo& info) {
  const std::vector<int> uses = edge_uses(model);
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    info.seams += edge.use == EdgeUse::kSeam ? 1 : 0;
    info.degenerate += edge.use == EdgeUse::kDegenerate ? 1 : 0;
    if (edge.use != EdgeUse::kReal) continue;
    if (info.smallest_edge == 0 || edge.length < model.edge(info.smallest_edge).length)
      info.smallest_edge = e;
    if (uses[static_cast<std::size_t>(e)] < 2) info.free_edges.push_back(e);
    if (edge.faces.size() > 2) info.nonmanifold.push_back(e);
  }
}

void add_faces(const Model& model, PartInfo& info) {
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (info.smallest_face == 0 || face.area < model.face(info.smallest_face).area) info.smallest_face = f;
    if (face.region[0] == face.region[1])
      info.dangling_faces.push_back(f);
    else
      info.area += face.area;
  }
}

}  // namespace

PartInfo part_info(const Model& model) {
  PartInfo info;
  for (const Vec3& node : model.facets().nodes) info.box.add(node);
  add_edges(model, info);
  add_faces(model, info);
  for (int r = 1; r <= model.count(3); ++r) info.volume += model.region(r).volume;
  info.default_size = default_size(model);
  return info;
}

}  // namespace octet
