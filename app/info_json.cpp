// SPDX-License-Identifier: BSD-3-Clause
// Keys are stable: tests/corpus.py and users' scripts read them.
#include "app/info_json.h"

#include <numbers>

#include "app/json.h"

namespace octet {
namespace {

Json box_json(const Box3& box) { return Json::array({vec_json(box.lo), vec_json(box.hi)}); }

const char* use_name(EdgeUse use) {
  switch (use) {
    case EdgeUse::kReal:
      return "real";
    case EdgeUse::kSeam:
      return "seam";
    default:
      return "degenerate";
  }
}

/// Adds the numbers as read of an entity, and what the file calls it.
void add_sources(const Model& model, int dim, const std::vector<std::vector<int>>& sources, int tag,
                 Json& json) {
  if (sources.empty()) return;
  const std::vector<int>& numbers = sources[static_cast<std::size_t>(tag)];
  json["as_read"] = numbers;
  if (!model.provenance().id_mark.empty()) json["ids"] = ids_in_file(model.provenance(), dim, numbers);
}

std::vector<std::vector<int>> sources_of(const Model& model, int dim) {
  if (model.provenance().as_read[static_cast<std::size_t>(dim)].empty()) return {};
  return sources(model.provenance(), dim, model.count(dim));
}

Json vertices_json(const Model& model) {
  Json json = Json::array();
  const auto numbers = sources_of(model, 0);
  for (int v = 1; v <= model.count(0); ++v) {
    const ModelVertex& vertex = model.vertex(v);
    json.push_back({{"tag", v},
                    {"name", vertex.name},
                    {"point", vec_json(vertex.point)},
                    {"tolerance", vertex.tolerance}});
    add_sources(model, 0, numbers, v, json.back());
  }
  return json;
}

void add_shape(const EdgeShape& shape, Json& json) {
  json["ends"] = {vec_json(shape.ends[0]), vec_json(shape.ends[1])};
  json["middle"] = vec_json(shape.middle);
  json["box"] = box_json(shape.box);
  if (!shape.arc) return;
  json["centre"] = vec_json(shape.arc->centre);
  json["axis"] = vec_json(shape.arc->axis);
  if (shape.arc->radii[0] == shape.arc->radii[1])
    json["radius"] = shape.arc->radii[0];
  else
    json["radii"] = shape.arc->radii;
}

Json edges_json(const Model& model, const EntityShapes& shapes) {
  Json json = Json::array();
  const auto numbers = sources_of(model, 1);
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    json.push_back({{"tag", e},
                    {"name", edge.name},
                    {"colour", edge.colour},
                    {"layer", edge.layer},
                    {"use", use_name(edge.use)},
                    {"curve", edge.use == EdgeUse::kDegenerate ? "point" : model.curve(e).kind()},
                    {"length", edge.length},
                    {"tolerance", edge.tolerance},
                    {"vertices", edge.vertex},
                    {"faces", edge.faces}});
    add_shape(shapes.edges[static_cast<std::size_t>(e)], json.back());
    add_sources(model, 1, numbers, e, json.back());
  }
  return json;
}

void add_shape(const FaceShape& shape, Json& json) {
  json["centre"] = vec_json(shape.centre);
  json["point"] = vec_json(shape.point);
  json["normal"] = vec_json(shape.normal);
  json["box"] = box_json(shape.box);
  if (!shape.round) return;
  const RoundShape& round = *shape.round;
  if (!round.axis.isZero()) json["axis"] = vec_json(round.axis);
  json["origin"] = vec_json(round.origin);
  if (round.radius > 0.0) json["radius"] = round.radius;
  if (round.minor_radius > 0.0) json["minor_radius"] = round.minor_radius;
  if (round.half_angle > 0.0) {
    json["radii"] = shape.radii;
    json["half_angle"] = round.half_angle * 180.0 / std::numbers::pi;
  }
  json["concave"] = shape.concave;
}

Json faces_json(const Model& model, const EntityShapes& shapes) {
  Json json = Json::array();
  const auto numbers = sources_of(model, 2);
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    json.push_back({{"tag", f},
                    {"name", face.name},
                    {"colour", face.colour},
                    {"layer", face.layer},
                    {"surface", model.surface(f).kind()},
                    {"area", face.area},
                    {"tolerance", face.tolerance},
                    {"regions", face.region}});
    add_shape(shapes.faces[static_cast<std::size_t>(f)], json.back());
    add_sources(model, 2, numbers, f, json.back());
  }
  return json;
}

Json regions_json(const Model& model, const EntityShapes& shapes) {
  Json json = Json::array();
  const auto numbers = sources_of(model, 3);
  for (int r = 1; r <= model.count(3); ++r) {
    const ModelRegion& region = model.region(r);
    json.push_back({{"tag", r},
                    {"name", region.name},
                    {"colour", region.colour},
                    {"layer", region.layer},
                    {"material", region.material},
                    {"density", region.density},
                    {"volume", region.volume},
                    {"faces", region.faces}});
    json.back()["centre"] = vec_json(shapes.regions[static_cast<std::size_t>(r)].centre);
    json.back()["box"] = box_json(shapes.regions[static_cast<std::size_t>(r)].box);
    add_sources(model, 3, numbers, r, json.back());
  }
  return json;
}

/// The tree as a flat list, an assembly before what it holds; `parent` and `first_use` are indices in it.
Json tree_json(const Model& model) {
  Json json = Json::array();
  for (const PartNode& node : model.provenance().tree) {
    json.push_back({{"name", node.name},
                    {"instance", node.instance},
                    {"parent", node.parent},
                    {"first_use", node.first_use},
                    {"colour", node.colour},
                    {"layer", node.layer},
                    {"material", node.material},
                    {"density", node.density},
                    {"solids", node.solids},
                    {"regions", node.regions}});
  }
  return json;
}

Json interfaces_json(const PartInfo& info) {
  Json json = Json::array();
  for (const Interface& shared : info.interfaces)
    json.push_back({{"regions", shared.regions}, {"faces", shared.faces}, {"area", shared.area}});
  return json;
}

Json touching_json(const PartInfo& info) {
  Json json = Json::array();
  for (const FaceContact& contact : info.touching)
    json.push_back({{"regions", contact.region},
                    {"faces", contact.face},
                    {"area", contact.area},
                    {"place", vec_json(contact.place)}});
  return json;
}

Json crossings_json(const PartInfo& info) {
  Json json = Json::array();
  for (const FaceCrossing& crossing : info.crossings)
    json.push_back(
        {{"faces", crossing.face}, {"place", vec_json(crossing.place)}, {"depth", crossing.depth}});
  return json;
}

Json overlaps_json(const Model& model, const PartInfo& info) {
  Json json = Json::array();
  for (const Overlap& overlap : info.overlaps) {
    Json names = Json::array();
    for (const int number : overlap.solids)
      names.push_back(model.provenance().as_read[3][static_cast<std::size_t>(number)].name);
    json.push_back({{"region", overlap.region},
                    {"solids", overlap.solids},
                    {"names", names},
                    {"volume", model.region(overlap.region).volume}});
  }
  return json;
}

Json changes_json(const PartInfo& info) {
  Json json = Json::array();
  for (const NumberChange& change : info.changes)
    json.push_back({{"dim", change.as_read.dim}, {"as_read", change.as_read.tag}, {"tags", change.tags}});
  return json;
}

Json left_out_json(const Model& model) {
  Json json = Json::array();
  for (const LeftOut& item : model.provenance().left_out)
    json.push_back({{"dim", item.entity.dim},
                    {"as_read", item.entity.tag},
                    {"name", item.name},
                    {"measure", item.measure},
                    {"place", vec_json(item.place)}});
  return json;
}

Json tiny_json(const PartInfo& info) {
  Json json = Json::array();
  for (const TinyFeature& feature : info.tiny)
    json.push_back({{"dim", feature.entity.dim},
                    {"tag", feature.entity.tag},
                    {"size", feature.size},
                    {"gap", feature.gap},
                    {"place", vec_json(feature.place)}});
  return json;
}

Json faults_json(const Model& model) {
  Json json = Json::array();
  for (const Fault& fault : model.parts().faults)
    json.push_back({{"dim", fault.entity.dim},
                    {"tag", fault.entity.tag},
                    {"place", vec_json(fault.place)},
                    {"cause", fault.cause}});
  return json;
}

Json wall_json(const Wall& wall) {
  return {{"thickness", wall.thickness},
          {"region", wall.region},
          {"faces", {wall.face, wall.opposite}},
          {"from", vec_json(wall.from)},
          {"to", vec_json(wall.to)}};
}

Json place_json(const AtPlace& at) {
  Json nearest = Json::array();
  for (const NearEntity& item : at.nearest)
    nearest.push_back({{"dim", item.entity.dim},
                       {"tag", item.entity.tag},
                       {"distance", item.distance},
                       {"point", vec_json(item.point)}});
  Json json{{"place", vec_json(at.place)}, {"regions", at.regions}, {"on", nullptr}, {"nearest", nearest}};
  if (at.on.valid()) json["on"] = {{"dim", at.on.dim}, {"tag", at.on.tag}};
  return json;
}

}  // namespace

std::string part_info_json(const std::string& part, const Model& model, const PartInfo& info,
                           const EntityShapes& shapes, const std::vector<AtPlace>& places) {
  Json json{{"octet", OCTET_VERSION}, {"part", part}, {"unit", model.unit()}};
  json["box"] = {{"lo", vec_json(info.box.lo)}, {"hi", vec_json(info.box.hi)}};
  json["size"] = vec_json(info.box.size());
  json["diagonal"] = info.box.diagonal();
  json["default_size"] = info.default_size;
  json["volume"] = info.volume;
  json["area"] = info.area;
  json["counts"] = {{"regions", model.count(3)}, {"faces", model.count(2)},
                    {"edges", model.count(1)},   {"vertices", model.count(0)},
                    {"seams", info.seams},       {"degenerate_edges", info.degenerate}};
  if (info.smallest_edge > 0)
    json["smallest_edge"] = {{"tag", info.smallest_edge}, {"length", model.edge(info.smallest_edge).length}};
  if (info.smallest_face > 0)
    json["smallest_face"] = {{"tag", info.smallest_face}, {"area", model.face(info.smallest_face).area}};
  if (info.thinnest) json["thinnest_wall"] = wall_json(*info.thinnest);
  json["free_edges"] = info.free_edges;
  json["nonmanifold_edges"] = info.contact.edges;
  json["tiny_features"] = tiny_json(info);
  if (info.widest_gap.tag > 0)
    json["widest_gap"] = {{"dim", info.widest_gap.dim},
                          {"tag", info.widest_gap.tag},
                          {"gap", model.tolerance_of(info.widest_gap)}};
  json["pinched_vertices"] = info.contact.vertices;
  json["embedded_faces"] = info.embedded_faces;
  json["dangling_faces"] = info.dangling_faces;
  json["crossings"] = crossings_json(info);
  json["notes"] = model.notes();
  json["tree"] = tree_json(model);
  json["interfaces"] = interfaces_json(info);
  json["touching"] = touching_json(info);
  json["overlaps"] = overlaps_json(model, info);
  json["changed_numbers"] = changes_json(info);
  json["left_out"] = left_out_json(model);
  json["faults"] = faults_json(model);
  json["regions"] = regions_json(model, shapes);
  json["faces"] = faces_json(model, shapes);
  json["edges"] = edges_json(model, shapes);
  json["vertices"] = vertices_json(model);
  if (!places.empty()) json["at"] = Json::array();
  for (const AtPlace& at : places) json["at"].push_back(place_json(at));
  // Names come from CAD files in any encoding: what is no UTF-8 is replaced, never thrown at.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace octet
