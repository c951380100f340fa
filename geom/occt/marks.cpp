// SPDX-License-Identifier: BSD-3-Clause
// Labels mark the entities as read; the model's entities take them over by what became of each.
#include "geom/occt/marks.h"

#include <TopExp.hxx>
#include <algorithm>
#include <map>
#include <utility>

#include "base/sort_unique.h"
#include "geom/occt/caps.h"
#include "geom/occt/left_out.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// By dimension and number as read, [0] unused.
using MarksAsRead = std::array<std::vector<Marks>, 4>;

void take(std::string& text, const std::string& other) {
  if (!other.empty()) text = other;
}

/// What `label` says replaces what was said before.
void mark(const Marks& label, bool with_name, Marks& marks) {
  if (with_name) take(marks.name, label.name);
  take(marks.colour, label.colour);
  take(marks.layer, label.layer);
  if (!label.material.empty())
    std::tie(marks.material, marks.density) = std::tie(label.material, label.density);
}

void mark_all(const ShapeLabel& label, const ShapeMaps& as_read, MarksAsRead& marks) {
  const TopAbs_ShapeEnum own = label.shape.ShapeType();
  for (int dim = 0; dim < 4; ++dim) {
    if (own != kShapeTypes[dim] && dim < 2) continue;
    TopTools_IndexedMapOfShape entities;
    TopExp::MapShapes(label.shape, kShapeTypes[dim], entities);
    const bool with_name = own == kShapeTypes[dim] || (dim == 3 && !label.is_assembly);
    for (int i = 1; i <= entities.Extent(); ++i)
      if (const int number = as_read.of[dim].FindIndex(entities(i)); number > 0)
        mark(label.marks, with_name, marks[static_cast<std::size_t>(dim)][static_cast<std::size_t>(number)]);
  }
}

MarksAsRead marks_as_read(const std::vector<ShapeLabel>& labels, const ShapeMaps& as_read) {
  MarksAsRead marks;
  for (int dim = 0; dim < 4; ++dim)
    marks[static_cast<std::size_t>(dim)].resize(static_cast<std::size_t>(as_read.of[dim].Extent()) + 1);
  for (const ShapeLabel& label : labels) mark_all(label, as_read, marks);
  return marks;
}

/// The marks of the entities of one dimension of the model.
std::vector<Marks> marks_of_model(int dim, const std::vector<Marks>& as_read, const Numbering& numbering) {
  std::vector<Marks> marks(static_cast<std::size_t>(numbering.count(dim)) + 1);
  // From the highest number down, so that the lowest has the last word.
  for (std::size_t number = as_read.size() - 1; number > 0; --number)
    for (const int tag : numbering.became[dim][number])
      mark(as_read[number], true, marks[static_cast<std::size_t>(tag)]);
  return marks;
}

void set_marks(const Marks& marks, ModelRegion& region) {
  region.name = marks.name;
  region.colour = marks.colour;
  region.layer = marks.layer;
  region.material = marks.material;
  region.density = marks.density;
}

void apply(const MarksAsRead& as_read, const Numbering& numbering, ModelParts& parts) {
  std::array<std::vector<Marks>, 4> marks;
  for (int dim = 0; dim < 4; ++dim)
    marks[static_cast<std::size_t>(dim)] =
        marks_of_model(dim, as_read[static_cast<std::size_t>(dim)], numbering);
  for (std::size_t i = 1; i < parts.vertices.size(); ++i) parts.vertices[i].name = marks[0][i].name;
  for (std::size_t i = 1; i < parts.edges.size(); ++i) {
    parts.edges[i].name = marks[1][i].name;
    parts.edges[i].colour = marks[1][i].colour;
    parts.edges[i].layer = marks[1][i].layer;
  }
  for (std::size_t i = 1; i < parts.faces.size(); ++i) {
    parts.faces[i].name = marks[2][i].name;
    parts.faces[i].colour = marks[2][i].colour;
    parts.faces[i].layer = marks[2][i].layer;
  }
  for (std::size_t i = 1; i < parts.regions.size(); ++i) set_marks(marks[3][i], parts.regions[i]);
  for (std::size_t cap = 0; cap < numbering.caps.size(); ++cap)
    for (const int tag : numbering.caps[cap])
      if (std::string& name = parts.faces[static_cast<std::size_t>(tag)].name; name.empty())
        name = cap_name(cap + 1);
}

/// The regions that no solid as read became, closed shells of the file or sewn ones, each with the numbers as
/// read of its faces. Faces that are new have none and do not count.
using ShellRegions = std::map<int, std::vector<std::vector<int>>>;

ShellRegions shell_regions(const Numbering& numbering, const ModelParts& parts) {
  std::vector<bool> from_solid(parts.regions.size(), false);
  for (const auto& tags : numbering.became[3])
    for (const int tag : tags) from_solid[static_cast<std::size_t>(tag)] = true;
  std::vector<std::vector<int>> numbers(parts.faces.size());
  for (std::size_t number = 1; number < numbering.became[2].size(); ++number)
    for (const int tag : numbering.became[2][number])
      numbers[static_cast<std::size_t>(tag)].push_back(static_cast<int>(number));
  ShellRegions regions;
  for (std::size_t r = 1; r < parts.regions.size(); ++r)
    if (!from_solid[r])
      for (const int face : parts.regions[r].faces)
        if (const auto& sources = numbers[static_cast<std::size_t>(face)]; !sources.empty())
          regions[static_cast<int>(r)].push_back(sources);
  return regions;
}

/// Those whose faces are all of this shape.
std::vector<int> regions_within(const TopoDS_Shape& shape, const ShellRegions& regions,
                                const ShapeMaps& as_read) {
  if (regions.empty()) return {};
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  const auto has = [&](int number) { return faces.Contains(as_read.of[2](number)); };
  std::vector<int> within;
  for (const auto& [region, sources] : regions)
    if (std::all_of(sources.begin(), sources.end(), [&](const std::vector<int>& numbers) {
          return std::any_of(numbers.begin(), numbers.end(), has);
        }))
      within.push_back(region);
  return within;
}

void mark_shell_regions(const std::vector<ShapeLabel>& labels, const ShellRegions& regions,
                        const ShapeMaps& as_read, ModelParts& parts) {
  for (const ShapeLabel& label : labels)
    for (const int r : regions_within(label.shape, regions, as_read)) {
      ModelRegion& region = parts.regions[static_cast<std::size_t>(r)];
      Marks marks{region.name, region.colour, region.layer, region.material, region.density};
      mark(label.marks, !label.is_assembly, marks);
      set_marks(marks, region);
    }
}

/// A solid belongs to the innermost part that holds it: the last one in the list.
std::vector<PartNode> tree_of(const std::vector<PlacedPart>& placed, const ShellRegions& shells,
                              const ShapeMaps& as_read, const Numbering& numbering) {
  std::vector<PartNode> tree;
  std::vector<int> owner(static_cast<std::size_t>(as_read.of[3].Extent()) + 1, -1);
  std::map<int, int> shell_owner;
  for (const PlacedPart& part : placed) {
    const auto index = static_cast<int>(tree.size());
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(part.shape, TopAbs_SOLID, solids);
    for (int i = 1; i <= solids.Extent(); ++i)
      owner[static_cast<std::size_t>(as_read.of[3].FindIndex(solids(i)))] = index;
    for (const int region : regions_within(part.shape, shells, as_read)) shell_owner[region] = index;
    tree.push_back(part.node);
  }
  for (std::size_t number = 1; number < owner.size(); ++number) {
    if (owner[number] < 0) continue;
    PartNode& node = tree[static_cast<std::size_t>(owner[number])];
    node.solids.push_back(static_cast<int>(number));
    const auto& tags = numbering.became[3][number];
    node.regions.insert(node.regions.end(), tags.begin(), tags.end());
  }
  for (const auto& [region, index] : shell_owner)
    tree[static_cast<std::size_t>(index)].regions.push_back(region);
  for (PartNode& node : tree) {
    sort_unique(node.regions);
  }
  return tree;
}

}  // namespace

void mark_entities(const CadDocument& document, const ShapeMaps& as_read, const Numbering& numbering,
                   ModelParts& parts) {
  const MarksAsRead marks = marks_as_read(document.labels, as_read);
  apply(marks, numbering, parts);
  const ShellRegions shells = shell_regions(numbering, parts);
  mark_shell_regions(document.labels, shells, as_read, parts);
  Provenance& provenance = parts.provenance;
  for (std::size_t dim = 0; dim < 4; ++dim) {
    provenance.as_read[dim].resize(marks[dim].size());
    const std::vector<int> ids = ids_of(as_read.of[dim], document.ids);
    for (std::size_t number = 1; number < marks[dim].size(); ++number)
      provenance.as_read[dim][number] = {marks[dim][number].name, numbering.became[dim][number], ids[number]};
  }
  provenance.id_mark = document.id_mark;
  provenance.tree = tree_of(document.tree, shells, as_read, numbering);
  provenance.left_out = left_out(as_read, numbering);
  for (LeftOut& item : provenance.left_out)
    item.name =
        marks[static_cast<std::size_t>(item.entity.dim)][static_cast<std::size_t>(item.entity.tag)].name;
}

}  // namespace octet
