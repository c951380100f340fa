// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#include "geom/occt/assemble.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <Standard_Failure.hxx>
#include <mutex>

#include "base/error.h"
#include "geom/occt/measure.h"
#include "geom/occt/numbering.h"
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

ModelParts assemble_unguarded(const CadDocument& document, const ReadOptions& options) {
  ModelParts parts;
  parts.unit = document.unit;
  const ShapeMaps as_read(document.shape);
  SolidSet set = collect_solids(document.shape, as_read);
  fuse_touching(set);
  const Numbering numbering = number_entities(as_read, set, set.notes);
  for (int tag = 1; tag <= numbering.count(3); ++tag) BRepLib::BuildCurves3d(numbering.solid(tag));
  parts.notes = set.notes;
  fill_topology(numbering, parts);
  tessellate(numbering, options.facet_deflection, parts);
  measure(numbering, parts);
  apply_labels(label_entities(document.labels, numbering, set), parts);
  return parts;
}

}  // namespace

OcctLock::OcctLock() { occt_mutex().lock(); }
OcctLock::~OcctLock() { occt_mutex().unlock(); }

ModelParts assemble(const CadDocument& document, const ReadOptions& options) {
  try {
    return assemble_unguarded(document, options);
  } catch (const Standard_Failure& failure) {
    throw InputError(fmt::format("the part cannot be analysed: {} ({})", failure.GetMessageString(),
                                 failure.DynamicType()->Name()));
  }
}

}  // namespace octet
