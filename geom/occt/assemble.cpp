// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#include "geom/occt/assemble.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <mutex>

#include "geom/occt/measure.h"
#include "geom/occt/tessellate.h"
#include "geom/occt/topology.h"

namespace octet {
namespace {

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

void apply_labels(const EntityLabels& labels, ModelParts& parts) {
  for (std::size_t i = 1; i < parts.vertices.size(); ++i) parts.vertices[i].name = labels.name[0][i];
  for (std::size_t i = 1; i < parts.edges.size(); ++i) parts.edges[i].name = labels.name[1][i];
  for (std::size_t i = 1; i < parts.faces.size(); ++i) {
    parts.faces[i].name = labels.name[2][i];
    parts.faces[i].colour = labels.colour[2][i];
  }
  for (std::size_t i = 1; i < parts.regions.size(); ++i) parts.regions[i].name = labels.name[3][i];
}

}  // namespace

OcctLock::OcctLock() { occt_mutex().lock(); }
OcctLock::~OcctLock() { occt_mutex().unlock(); }

AssembledPart assemble(const CadDocument& document, const ReadOptions& options, const StageLog& log) {
  AssembledPart part;
  ModelParts& parts = part.parts;
  parts.unit = document.unit;
  const ShapeMaps as_read(document.shape);
  log("collecting the solids");
  SolidSet set = collect_solids(document.shape, as_read);
  log(fmt::format("fusing {} solid(s) that may touch", set.solids.size()));
  fuse_touching(set);
  part.numbering = number_entities(as_read, set, set.notes);
  const Numbering& numbering = part.numbering;
  log("building the edges' curves");
  for (int tag = 1; tag <= numbering.count(3); ++tag) BRepLib::BuildCurves3d(numbering.solid(tag));
  parts.notes = set.notes;
  log("analysing the topology");
  fill_topology(numbering, parts);
  log("triangulating the faces");
  tessellate(numbering, options.facet_deflection, log, parts);
  log("measuring the entities");
  measure(numbering, parts);
  apply_labels(label_entities(document.labels, numbering, set), parts);
  return part;
}

}  // namespace octet
