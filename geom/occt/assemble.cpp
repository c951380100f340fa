// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#include "geom/occt/assemble.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <algorithm>
#include <array>
#include <mutex>

#include "geom/occt/heal.h"
#include "geom/occt/marks.h"
#include "geom/occt/measure.h"
#include "geom/occt/tessellate.h"
#include "geom/occt/topology.h"

namespace octet {
namespace {

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string solid_text(const ModelParts& parts, int number) {
  const std::string& name = parts.provenance.as_read[3][static_cast<std::size_t>(number)].name;
  return name.empty() ? fmt::format("Solid {}", number) : fmt::format("Solid {} \"{}\"", number, name);
}

/// Pieces that two solids of the file both fill, the largest first.
void note_overlaps(ModelParts& parts) {
  std::vector<Overlap> found = overlaps(parts.provenance, static_cast<int>(parts.regions.size()) - 1);
  const auto volume = [&](const Overlap& o) {
    return parts.regions[static_cast<std::size_t>(o.region)].volume;
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Overlap& a, const Overlap& b) { return volume(a) > volume(b); });
  constexpr std::size_t kTold = 10;
  for (std::size_t i = 0; i < found.size() && i < kTold; ++i) {
    std::string solids;
    for (const int number : found[i].solids)
      solids += (solids.empty() ? "" : " and ") + solid_text(parts, number);
    parts.notes.push_back(fmt::format("{} overlap: what they share is Region {}, {:.6g} mm^3", solids,
                                      found[i].region, volume(found[i])));
  }
  if (found.size() > kTold)
    parts.notes.push_back(fmt::format("and {} more overlaps of solids", found.size() - kTold));
}

void note_left_out(ModelParts& parts) {
  for (const int dim : {2, 1, 0}) {
    static constexpr std::array<const char*, 3> kKind{"Vertex", "Edge", "Face"};
    int count = 0;
    const LeftOut* first = nullptr;
    for (const LeftOut& item : parts.provenance.left_out)
      if (item.entity.dim == dim && count++ == 0) first = &item;
    if (count == 0) continue;
    const std::string word = kKind[static_cast<std::size_t>(dim)];
    parts.notes.push_back(fmt::format(
        "{} {} number(s) of the file bound no volume and are left out, the first is {} {}{} at ({:.6g}, "
        "{:.6g}, "
        "{:.6g})",
        count, word, word, first->entity.tag, first->name.empty() ? "" : " \"" + first->name + "\"",
        first->place.x(), first->place.y(), first->place.z()));
  }
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
  if (options.fuse) {
    log(fmt::format("fusing {} solid(s) that may touch", set.solids.size()));
    fuse_touching(set);
  }
  add_entities(as_read, set, options, log, part);
  if (turn_back(part, set)) {
    parts = {};
    add_entities(as_read, set, options, log, part);
  }
  const Numbering& numbering = part.numbering;
  parts.unit = document.unit;
  log("measuring the entities");
  measure(numbering, parts);
  mark_entities(document, as_read, numbering, parts);
  note_overlaps(parts);
  note_left_out(parts);
  return part;
}

}  // namespace octet
