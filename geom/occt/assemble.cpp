// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#include "geom/occt/assemble.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <mutex>

#include "geom/occt/heal.h"
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

/// Numbers, topology and facets of the solids as they are now.
void add_entities(const ShapeMaps& as_read, const SolidSet& set, const ReadOptions& options,
                  const StageLog& log, AssembledPart& part) {
  part.parts.notes = set.notes;
  part.numbering = number_entities(as_read, set, part.parts.notes);
  const Numbering& numbering = part.numbering;
  log("building the edges' curves");
  for (int tag = 1; tag <= numbering.count(3); ++tag) BRepLib::BuildCurves3d(numbering.solid(tag));
  log("analysing the topology");
  fill_topology(numbering, part.parts);
  log("triangulating the faces");
  tessellate(numbering, options.facet_deflection, log, part.parts);
}

/// Volume within the facets of each region, by tag.
std::vector<double> facet_volumes(const ModelParts& parts) {
  std::vector<double> volume(parts.regions.size(), 0.0);
  const Facets& facets = parts.facets;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto& [a, b, c] = facets.triangles[i];
    const Vec3 origin = facets.nodes.front();
    const double share =
        (facets.nodes[a] - origin).dot((facets.nodes[b] - origin).cross(facets.nodes[c] - origin)) / 6.0;
    const auto& region = parts.faces[facets.face[i]].region;
    volume[region[0]] += share;
    volume[region[1]] -= share;
  }
  return volume;
}

/// Turns solids that fill all space but a hole, where faces know one side only; returns whether there were
/// any.
bool turn_back(const AssembledPart& part, SolidSet& set) {
  bool turned = false;
  const std::vector<double> volume = facet_volumes(part.parts);
  for (int region = 1; region < static_cast<int>(volume.size()); ++region) {
    if (volume[region] >= 0.0) continue;
    for (TopoDS_Shape& solid : set.solids) {
      if (!solid.IsSame(part.numbering.solid(region))) continue;
      solid.Reverse();
      set.notes.push_back(inside_out_note(fmt::format("Solid {}", region)));
      turned = true;
    }
  }
  return turned;
}

}  // namespace

OcctLock::OcctLock() { occt_mutex().lock(); }
OcctLock::~OcctLock() { occt_mutex().unlock(); }

AssembledPart assemble(const CadDocument& document, const ReadOptions& options, const StageLog& log) {
  AssembledPart part;
  ModelParts& parts = part.parts;
  const ShapeMaps as_read(document.shape);
  log("collecting the solids");
  SolidSet set = collect_solids(document.shape, as_read, options.sew_tolerance);
  heal(as_read, options.sew_tolerance, log, set);
  log(fmt::format("fusing {} solid(s) that may touch", set.solids.size()));
  fuse_touching(set);
  add_entities(as_read, set, options, log, part);
  if (turn_back(part, set)) {
    parts = {};
    add_entities(as_read, set, options, log, part);
  }
  const Numbering& numbering = part.numbering;
  parts.unit = document.unit;
  log("measuring the entities");
  measure(numbering, parts);
  apply_labels(label_entities(document.labels, numbering, set), parts);
  return part;
}

}  // namespace octet
