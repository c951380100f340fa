// SPDX-License-Identifier: BSD-3-Clause
// Tags of the entities of the solids: as far as may be, their numbers in the shape as read.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <string>
#include <vector>

#include "geom/occt/solids.h"

namespace octet {

/// Tags run from 1; maps index entities by dimension. An entity carries the orientation it has where it is
/// first met, so a face's normal points out of the first solid that holds it.
struct Numbering {
  TopTools_IndexedMapOfShape of[4];
  /// By dimension and number as read ([0] unused): the tags that it became, ascending.
  std::vector<std::vector<int>> became[4];
  std::vector<std::vector<int>> caps;  ///< the tags that each of SolidSet::caps became

  [[nodiscard]] int count(int dim) const { return of[dim].Extent(); }
  [[nodiscard]] int tag(int dim, const TopoDS_Shape& shape) const { return of[dim].FindIndex(shape); }
  [[nodiscard]] const TopoDS_Vertex& vertex(int tag) const { return TopoDS::Vertex(of[0](tag)); }
  [[nodiscard]] const TopoDS_Edge& edge(int tag) const { return TopoDS::Edge(of[1](tag)); }
  [[nodiscard]] const TopoDS_Face& face(int tag) const { return TopoDS::Face(of[2](tag)); }
  [[nodiscard]] const TopoDS_Shape& solid(int tag) const { return of[3](tag); }
};

/// Every entity keeps its number as read through sewing and fusing while that is possible. Of those that one
/// entity was split into, one keeps the number: one that is part of nothing else, where there is such; of
/// those that became one, the lowest stays. What has no number of its own takes those that fell free, then
/// new ones; so do, last of all, entities whose number is beyond the count. Appends a note for each dimension
/// in which numbers changed.
[[nodiscard]] Numbering number_entities(const ShapeMaps& as_read, const SolidSet& set,
                                        std::vector<std::string>& notes);

}  // namespace octet
