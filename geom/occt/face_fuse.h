// SPDX-License-Identifier: BSD-3-Clause
// A general fuse of faces of a solid, whose pieces take their places in it.
#pragma once

#include <BOPAlgo_Builder.hxx>
#include <BRepTools_History.hxx>
#include <BRepTools_ReShape.hxx>
#include <IntTools_Context.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

class FaceFuse {
 public:
  /// `edges` take part in the fuse of the faces; `tolerance` 0: none but the faces' own.
  FaceFuse(const TopTools_IndexedMapOfShape& faces, const std::vector<TopoDS_Edge>& edges, double tolerance);

  [[nodiscard]] bool failed() const { return builder_.HasErrors(); }
  /// What the fuse made of a face, or of an edge or a vertex of one; itself where it did nothing.
  [[nodiscard]] TopTools_ListOfShape images_of(const TopoDS_Shape& shape);
  /// The solid with the pieces in place of the faces. Other faces only get their edges and vertices changed;
  /// edges that took the place of others may lack curves there.
  [[nodiscard]] TopoDS_Shape apply(const TopoDS_Shape& solid);
  /// Of all that apply() changed but the solids.
  [[nodiscard]] Handle(BRepTools_History) history() const { return changes_->History(); }

 private:
  void exchange_all();
  void exchange(const TopoDS_Shape& shape);
  bool turned(TopoDS_Shape image, const TopoDS_Shape& shape);

  TopTools_IndexedMapOfShape faces_;  ///< forward
  BOPAlgo_Builder builder_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
  Handle(BRepTools_ReShape) changes_ = new BRepTools_ReShape;
  bool exchanged_ = false;
};

}  // namespace octet
