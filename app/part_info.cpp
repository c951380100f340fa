// SPDX-License-Identifier: BSD-3-Clause
// Plain sums and extremes over the model's entities.
#include "app/part_info.h"

#include <algorithm>
#include <map>

#include "app/own_frame.h"
#include "app/scaled_sizes.h"

namespace octet {
namespace {

/// How often the boundaries of faces run along each edge.
std::vector<int> edge_uses(const Model& model) {
  std::vector<int> uses(static_cast<std::size_t>(model.count(1)) + 1, 0);
  for (int f = 1; f <= model.count(2); ++f)
    for (const FaceBoundary& side : model.face(f).boundary)
      uses[static_cast<std::size_t>(side.edge)] += model.is_embedded(f) ? 2 : 1;
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
    if (edge.tolerance > model.tolerance_of(info.widest_gap)) info.widest_gap = model_edge(e);
  }
  for (int v = 1; v <= model.count(0); ++v)
    if (model.vertex(v).tolerance > model.tolerance_of(info.widest_gap)) info.widest_gap = model_vertex(v);
}

void add_faces(const Model& model, PartInfo& info) {
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (info.smallest_face == 0 || face.area < model.face(info.smallest_face).area) info.smallest_face = f;
    if (model.is_outside(f)) {
      info.dangling_faces.push_back(f);
      continue;
    }
    if (model.is_embedded(f)) info.embedded_faces.push_back(f);
    info.area += face.area;
  }
}

std::vector<Interface> interfaces_of(const Model& model) {
  std::map<std::array<int, 2>, Interface> by_regions;
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (face.region[0] == 0 || face.region[1] == 0 || model.is_embedded(f)) continue;
    const auto [low, high] = std::minmax(face.region[0], face.region[1]);
    Interface& shared = by_regions[{low, high}];
    shared.regions = {low, high};
    shared.faces.push_back(f);
    shared.area += face.area;
  }
  std::vector<Interface> interfaces;
  for (auto& [regions, shared] : by_regions) interfaces.push_back(std::move(shared));
  return interfaces;
}

}  // namespace

PartInfo part_info(const Model& model) {
  PartInfo info;
  info.crossings = model.crossings();
  for (const Vec3& node : model.facets().nodes) info.box.add(node);
  add_edges(model, info);
  add_faces(model, info);
  for (int r = 1; r <= model.count(3); ++r) info.volume += model.region(r).volume;
  info.contact = self_contact(model);
  info.interfaces = interfaces_of(model);
  info.touching = face_contacts(model);
  info.overlaps = overlaps(model.provenance(), model.count(3));
  info.changes = changed_numbers(model.provenance());
  std::erase_if(info.changes, [](const NumberChange& change) { return change.tags.empty(); });
  info.tiny = tiny_features(model);
  info.thinnest = thinnest_wall(model);
  info.default_size = with_default_size(OwnFrame(model, {}).model(), {}).size;
  return info;
}

}  // namespace octet
