// SPDX-License-Identifier: BSD-3-Clause
// Names, boxes (geom/entity_boxes) and bounds of all entities.
#include "app/outline.h"

#include "geom/entity_boxes.h"

namespace octet {
namespace {

OutlineEntity outline_vertex(const Model& model, int tag) {
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = model.vertex(tag).name;
  entity.box.add(model.vertex(tag).point);
  return entity;
}

OutlineEntity outline_edge(const Model& model, int tag, const Box3& box) {
  const ModelEdge& edge = model.edge(tag);
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = edge.name;
  entity.colour = edge.colour;
  entity.layer = edge.layer;
  entity.box = box;
  for (const int v : edge.vertex)  // which may lie off the curve's ends
    if (v > 0) entity.box.add(model.vertex(v).point);
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

OutlineEntity outline_region(const Model& model, int tag, const Box3& box) {
  const ModelRegion& region = model.region(tag);
  OutlineEntity entity;
  entity.tag = tag;
  entity.name = region.name;
  entity.colour = region.colour;
  entity.layer = region.layer;
  entity.material = region.material;
  entity.box = box;
  for (const int f : region.faces) {
    if (model.is_embedded(f)) continue;
    // The face normal points from region[0] to region[1]: outwards for the region behind it.
    entity.bounded_by.push_back(model.face(f).region[0] == tag ? f : -f);
  }
  return entity;
}

}  // namespace

ModelOutline outline_of(const Model& model) {
  ModelOutline outline;
  const EntityBoxes boxes = entity_boxes(model);
  const auto at = [](int tag) { return static_cast<std::size_t>(tag); };
  for (int v = 1; v <= model.count(0); ++v) outline.entities[0].push_back(outline_vertex(model, v));
  for (int e = 1; e <= model.count(1); ++e)
    outline.entities[1].push_back(outline_edge(model, e, boxes.edge[at(e)]));
  for (int f = 1; f <= model.count(2); ++f)
    outline.entities[2].push_back(outline_face(model, f, boxes.face[at(f)]));
  for (int r = 1; r <= model.count(3); ++r)
    outline.entities[3].push_back(outline_region(model, r, boxes.region[at(r)]));
  return outline;
}

}  // namespace octet
