// SPDX-License-Identifier: BSD-3-Clause
// Tags of the entities of the solids, in the order of the shape as read.
#include "geom/occt/numbering.h"

#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Compound.hxx>

namespace octet {
namespace {

constexpr const char* kPlural[4] = {"vertices", "edges", "faces", "solids"};
constexpr TopAbs_ShapeEnum kTypes[4] = {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID};

/// What became of `shape`; itself when nothing did.
TopTools_ListOfShape images_of(const TopoDS_Shape& shape, const SolidSet& set) {
  TopTools_ListOfShape images;
  if (BRepTools_History::IsSupportedType(shape)) images = set.history->Modified(shape);
  if (images.IsEmpty()) images.Append(shape);
  return images;
}

ShapeMaps maps_of(const std::vector<TopoDS_Shape>& solids) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& solid : solids) builder.Add(all, solid);
  return ShapeMaps(all);
}

void number_dimension(int dim, const ShapeMaps& as_read, const ShapeMaps& final, const SolidSet& set,
                      TopTools_IndexedMapOfShape& tags) {
  const auto add = [&](const TopoDS_Shape& shape) {
    const int index = final.of[dim].FindIndex(shape);
    if (index == 0) return false;
    tags.Add(final.of[dim](index));
    return true;
  };
  for (int i = 1; i <= as_read.of[dim].Extent(); ++i)
    for (const TopoDS_Shape& image : images_of(as_read.of[dim](i), set))
      if (add(image)) break;
  for (int i = 1; i <= as_read.of[dim].Extent(); ++i)
    for (const TopoDS_Shape& image : images_of(as_read.of[dim](i), set)) add(image);
  for (int i = 1; i <= final.of[dim].Extent(); ++i) tags.Add(final.of[dim](i));
}

void note_changes(int dim, const ShapeMaps& as_read, const SolidSet& set, const Numbering& numbering,
                  std::vector<std::string>& notes) {
  for (int i = 1; i <= as_read.of[dim].Extent(); ++i) {
    const int tag = numbering.tag(dim, images_of(as_read.of[dim](i), set).First());
    if (tag == i || tag == 0) continue;
    notes.push_back(fmt::format("numbers of {} differ from the file from number {} on", kPlural[dim], i));
    return;
  }
}

void set_labels(const ShapeLabel& label, int dim, int tag, EntityLabels& labels, bool with_name) {
  if (tag == 0) return;
  if (with_name && !label.name.empty()) labels.name[dim][tag] = label.name;
  if (!label.colour.empty()) labels.colour[dim][tag] = label.colour;
}

int dimension_of(TopAbs_ShapeEnum type) {
  for (int dim = 0; dim < 4; ++dim)
    if (kTypes[dim] == type) return dim;
  return -1;
}

}  // namespace

Numbering number_entities(const ShapeMaps& as_read, const SolidSet& set, std::vector<std::string>& notes) {
  const ShapeMaps final = maps_of(set.solids);
  Numbering numbering;
  for (int dim = 0; dim < 4; ++dim) {
    number_dimension(dim, as_read, final, set, numbering.of[dim]);
    note_changes(dim, as_read, set, numbering, notes);
  }
  return numbering;
}

EntityLabels label_entities(const std::vector<ShapeLabel>& labels, const Numbering& numbering,
                            const SolidSet& set) {
  EntityLabels result;
  for (int dim = 0; dim < 4; ++dim) {
    result.name[dim].resize(static_cast<std::size_t>(numbering.count(dim)) + 1);
    result.colour[dim].resize(static_cast<std::size_t>(numbering.count(dim)) + 1);
  }
  for (const ShapeLabel& label : labels) {
    const int own = dimension_of(label.shape.ShapeType());
    if (own >= 0)
      for (const TopoDS_Shape& image : images_of(label.shape, set))
        set_labels(label, own, numbering.tag(own, image), result, true);
    if (own == 2) continue;
    // What is said of a whole is said of its solids and faces, but for a name that several would share.
    TopTools_IndexedMapOfShape solids, faces;
    if (own != 3) TopExp::MapShapes(label.shape, TopAbs_SOLID, solids);
    TopExp::MapShapes(label.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= solids.Extent(); ++i)
      for (const TopoDS_Shape& image : images_of(solids(i), set))
        set_labels(label, 3, numbering.tag(3, image), result, solids.Extent() == 1);
    for (int i = 1; i <= faces.Extent(); ++i)
      for (const TopoDS_Shape& image : images_of(faces(i), set))
        set_labels(label, 2, numbering.tag(2, image), result, false);
  }
  return result;
}

}  // namespace octet
