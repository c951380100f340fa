// SPDX-License-Identifier: BSD-3-Clause
// Tags of the entities of the solids, in the order of the shape as read.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <string>
#include <vector>

#include "geom/occt/document.h"
#include "geom/occt/solids.h"

namespace octet {

/// Tags run from 1; maps index entities by dimension. An entity carries the orientation it has where it is
/// first met, so a face's normal points out of the first solid that holds it.
struct Numbering {
  TopTools_IndexedMapOfShape of[4];

  [[nodiscard]] int count(int dim) const { return of[dim].Extent(); }
  [[nodiscard]] int tag(int dim, const TopoDS_Shape& shape) const { return of[dim].FindIndex(shape); }
  [[nodiscard]] const TopoDS_Vertex& vertex(int tag) const { return TopoDS::Vertex(of[0](tag)); }
  [[nodiscard]] const TopoDS_Edge& edge(int tag) const { return TopoDS::Edge(of[1](tag)); }
  [[nodiscard]] const TopoDS_Face& face(int tag) const { return TopoDS::Face(of[2](tag)); }
  [[nodiscard]] const TopoDS_Shape& solid(int tag) const { return of[3](tag); }
};

/// Entities keep the order of `as_read` through sewing and fusing: the first image of each comes in its
/// place, further pieces and new entities at the end. Appends a note when tags differ from the shape as read.
[[nodiscard]] Numbering number_entities(const ShapeMaps& as_read, const SolidSet& set,
                                        std::vector<std::string>& notes);

/// Names and colours by dimension and tag ([0] unused).
struct EntityLabels {
  std::vector<std::string> name[4], colour[4];
};

/// Labels follow their shapes through sewing and fusing; a colour of a solid or an assembly goes down to its
/// faces, a name of an assembly of one solid goes to that solid.
[[nodiscard]] EntityLabels label_entities(const std::vector<ShapeLabel>& labels, const Numbering& numbering,
                                          const SolidSet& set);

}  // namespace octet
