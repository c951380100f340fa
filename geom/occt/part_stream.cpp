// SPDX-License-Identifier: BSD-3-Clause
// A part between processes: what was measured of it, and the shapes its exact geometry is made from.
#include "geom/occt/part_stream.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <sstream>

#include "base/check.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/topology.h"

namespace octet {
namespace {

// Every field is named in a structured binding: a new one does not compile before it is passed on.
void pass(auto& stream, auto& vertex) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(vertex)>>, ModelVertex> {
  auto& [point, edges, tolerance, name] = vertex;
  stream(point, edges, tolerance, name);
}

void pass(auto& stream, auto& edge) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(edge)>>, ModelEdge> {
  auto& [vertex, t0, t1, use, faces, length, tolerance, name, colour, layer] = edge;
  stream(vertex, t0, t1, use, faces, length, tolerance, name, colour, layer);
}

void pass(auto& stream, auto& face) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(face)>>, ModelFace> {
  auto& [boundary, vertices, region, reversed, euler, area, tolerance, name, colour, layer] = face;
  stream(boundary, vertices, region, reversed, euler, area, tolerance, name, colour, layer);
}

void pass(auto& stream, auto& region) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(region)>>, ModelRegion> {
  auto& [faces, volume, name, colour, layer, material, density] = region;
  stream(faces, volume, name, colour, layer, material, density);
}

void pass(auto& stream, auto& entity) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(entity)>>, EntityAsRead> {
  auto& [name, tags, id] = entity;
  stream(name, tags, id);
}

void pass(auto& stream, auto& node) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(node)>>, PartNode> {
  auto& [name, instance, parent, first_use, colour, layer, material, density, solids, regions] = node;
  stream(name, instance, parent, first_use, colour, layer, material, density, solids, regions);
}

void pass(auto& stream, auto& item) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(item)>>, LeftOut> {
  auto& [entity, name, measure, place] = item;
  stream(entity, name, measure, place);
}

void pass(auto& stream, auto& fault) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(fault)>>, Fault> {
  auto& [entity, place, cause, advice, as_read] = fault;
  stream(entity, place, cause, advice, as_read);
}

void pass_facets(auto& stream, auto& facets) {
  auto& [nodes, triangles, face, uv, deviation, edge_deviation] = facets;
  stream(nodes, triangles, face, uv, deviation, edge_deviation);
}

void pass_entities(ByteWriter& stream, const auto& entities) {
  stream(static_cast<std::uint64_t>(entities.size()));
  for (const auto& entity : entities) pass(stream, entity);
}

void pass_entities(ByteReader& stream, auto& entities) {
  std::uint64_t count = 0;
  stream(count);
  entities.resize(count);
  for (auto& entity : entities) pass(stream, entity);
}

void pass_provenance(auto& stream, auto& provenance) {
  auto& [as_read, tree, left_out, id_mark] = provenance;
  for (auto& entities : as_read) pass_entities(stream, entities);
  pass_entities(stream, tree);
  pass_entities(stream, left_out);
  stream(id_mark);
}

void pass_parts(auto& stream, auto& parts) {
  auto& [vertices, edges, faces, regions, curves, surfaces, trims, facets, unit, accuracy, taken_away, apart,
         notes, faults, provenance, whole_tag] = parts;
  pass_entities(stream, vertices);
  pass_entities(stream, edges);
  pass_entities(stream, faces);
  pass_entities(stream, regions);
  pass_facets(stream, facets);
  stream(unit, accuracy, taken_away, apart, notes);
  pass_entities(stream, faults);
  pass_provenance(stream, provenance);
  for (auto& tags : whole_tag) stream(tags);
}

/// Compounds of the vertices, edges, faces and solids in the order of their tags.
TopoDS_Shape bundle(const Numbering& numbering) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (int dim = 3; dim >= 0; --dim) {
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int tag = 1; tag <= numbering.count(dim); ++tag) builder.Add(compound, numbering.of[dim](tag));
    builder.Add(all, compound);
  }
  return all;
}

Numbering unbundle(const TopoDS_Shape& all) {
  Numbering numbering;
  int dim = 3;
  for (TopoDS_Iterator compounds(all); compounds.More(); compounds.Next(), --dim)
    for (TopoDS_Iterator it(compounds.Value()); it.More(); it.Next()) numbering.of[dim].Add(it.Value());
  return numbering;
}

}  // namespace

std::string encode_shape(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BinTools::Write(shape, out, false, false, BinTools_FormatVersion_CURRENT);
  return std::move(out).str();
}

TopoDS_Shape decode_shape(const std::string& bytes) {
  std::istringstream in(bytes);
  TopoDS_Shape shape;
  BinTools::Read(shape, in);
  return shape;
}

std::string encode_part(const Numbering& numbering, const ModelParts& parts) {
  ByteWriter out;
  pass_parts(out, parts);
  out(encode_shape(bundle(numbering)));
  return std::move(out.bytes);
}

ModelParts decode_part(std::string_view bytes) {
  ByteReader in(bytes);
  ModelParts parts;
  pass_parts(in, parts);
  std::string shapes;
  in(shapes);
  const Numbering numbering = unbundle(decode_shape(shapes));
  const std::size_t counts[4] = {parts.vertices.size(), parts.edges.size(), parts.faces.size(),
                                 parts.regions.size()};
  for (int dim = 0; dim < 4; ++dim)
    OCTET_CHECK(counts[dim] == static_cast<std::size_t>(numbering.count(dim)) + 1);
  make_geometry(numbering, parts);
  return parts;
}

}  // namespace octet
