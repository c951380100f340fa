// SPDX-License-Identifier: BSD-3-Clause
// Boxes come from the facets, grown by their measured deviation, so they hold the exact entity.
#include "app/outline.h"

#include <algorithm>

namespace octet {
namespace {

constexpr int kCurveSamples = 32;

Box3 edge_box(const Model& model, int tag) {
  const ModelEdge& edge = model.edge(tag);
  Box3 box;
  for (const int v : edge.vertex)
    if (v > 0) box.add(model.vertex(v).point);
  if (edge.use == EdgeUse::kDegenerate) return box;
  double longest = 0.0;
  Vec3 last = model.edge_point(tag, edge.t0);
  for (int i = 0; i <= kCurveSamples; ++i) {
    const Vec3 p = model.edge_point(tag, edge.t0 + (edge.t1 - edge.t0) * i / kCurveSamples);
    box.add(p);
    longest = std::max(longest, (p - last).norm());
    last = p;
  }
  // A curve leaves the box of its samples by no more than its arcs bulge: half a sample's step covers that.
  const bool straight = box.diagonal() >= edge.length * (1.0 - 1e-12);
  return straight ? box : box.grown(0.5 * longest);
}

std::vector<Box3> face_boxes(const Model& model) {
  std::vector<Box3> boxes(static_cast<std::size_t>(model.count(2)) + 1);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const auto node : facets.triangles[t])
      boxes[static_cast<std::size_t>(facets.face[t])].add(facets.nodes[node]);
  for (std::size_t f = 1; f < boxes.size(); ++f)
    if (!boxes[f].empty() && f < facets.deviation.size()) boxes[f] = boxes[f].grown(facets.deviation[f]);
  return boxes;
}

OutlineEntity outline_vertex(const Model& model, int tag) {
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = model.vertex(tag).name;
  entity.box.add(model.vertex(tag).point);
  return entity;
}

OutlineEntity outline_edge(const Model& model, int tag) {
  const ModelEdge& edge = model.edge(tag);
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = edge.name;
  entity.colour = edge.colour;
  entity.layer = edge.layer;
  entity.box = edge_box(model, tag);
  if (edge.vertex[0] > 0) entity.bounded_by.push_back(edge.vertex[0]);
  if (edge.vertex[1] > 0) entity.bounded_by.push_back(-edge.vertex[1]);
  return entity;
}

OutlineEntity outline_face(const Model& model, int tag, const Box3& box) {
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = model.face(tag).name;
  entity.colour = model.face(tag).colour;
  entity.layer = model.face(tag).layer;
  entity.box = box;
  for (const FaceBoundary& side : model.face(tag).boundary)
    if (model.edge(side.edge).use == EdgeUse::kReal) entity.bounded_by.push_back(side.sense * side.edge);
  return entity;
}

OutlineEntity outline_region(const Model& model, int tag, const std::vector<Box3>& boxes) {
  const ModelRegion& region = model.region(tag);
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = region.name;
  entity.colour = region.colour;
  entity.layer = region.layer;
  entity.material = region.material;
  for (const int f : region.faces) {
    entity.box.add(boxes[static_cast<std::size_t>(f)]);
    if (model.is_embedded(f)) continue;
    // The face normal points from region[0] to region[1]: outwards for the region behind it.
    entity.bounded_by.push_back(model.face(f).region[0] == tag ? f : -f);
  }
  return entity;
}

}  // namespace

ModelOutline outline_of(const Model& model) {
  ModelOutline outline;
  const std::vector<Box3> boxes = face_boxes(model);
  for (int v = 1; v <= model.count(0); ++v) outline.entities[0].push_back(outline_vertex(model, v));
  for (int e = 1; e <= model.count(1); ++e) outline.entities[1].push_back(outline_edge(model, e));
  for (int f = 1; f <= model.count(2); ++f)
    outline.entities[2].push_back(outline_face(model, f, boxes[static_cast<std::size_t>(f)]));
  for (int r = 1; r <= model.count(3); ++r) outline.entities[3].push_back(outline_region(model, r, boxes));
  return outline;
}

}  // namespace octet
