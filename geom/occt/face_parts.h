// SPDX-License-Identifier: BSD-3-Clause
// Faces exchanged for parts of themselves, once edges are cut.
#pragma once

#include <BRepTools_ReShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <functional>
#include <vector>

#include "geom/occt/repair.h"

namespace octet {

/// Faces of a solid on their way to be several each.
class FaceParts {
 public:
  /// `cut`: the solid with its edges cut where parts will meet.
  FaceParts(const TopoDS_Shape& solid, Repair cut);
  /// The face makes way for parts_of(it, turned forward, as cutting left it), where these are two or more.
  void part(const TopoDS_Face& face,
            const std::function<std::vector<TopoDS_Face>(const TopoDS_Face&)>& parts_of);
  /// `entities` are the faces that made way; where there are none, edges are not cut either.
  [[nodiscard]] Repair apply() const;

 private:
  TopoDS_Shape solid_;
  Repair cut_;
  Handle(BRepTools_ReShape) changes_;
  std::vector<TopoDS_Shape> parted_;
};

/// What the edge, as it runs in (u,v) of the face, adds to the area that its loop goes around: that of the
/// fan from the origin to points along it. Positive to the left.
[[nodiscard]] double area_along(const TopoDS_Edge& edge, const TopoDS_Face& face);

}  // namespace octet
