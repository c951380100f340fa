// SPDX-License-Identifier: BSD-3-Clause
// Vertices are exchanged first, then edges, then faces.
#include "geom/occt/face_fuse.h"

#include <BOPTools_AlgoTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Pieces of an edge along it.
std::vector<TopoDS_Shape> in_order(const TopTools_ListOfShape& images) {
  std::vector<TopoDS_Shape> sorted(images.begin(), images.end());
  const auto start = [](const TopoDS_Shape& edge) {
    double first = 0.0, last = 0.0;
    BRep_Tool::Range(TopoDS::Edge(edge), first, last);
    return first;
  };
  if (!sorted.empty() && sorted.front().ShapeType() == TopAbs_EDGE)
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const auto& a, const auto& b) { return start(a) < start(b); });
  return sorted;
}

}  // namespace

FaceFuse::FaceFuse(const TopTools_IndexedMapOfShape& faces, const std::vector<TopoDS_Edge>& edges,
                   double tolerance) {
  for (int i = 1; i <= faces.Extent(); ++i) faces_.Add(faces(i).Oriented(TopAbs_FORWARD));
  for (int i = 1; i <= faces_.Extent(); ++i) builder_.AddArgument(faces_(i));
  for (const TopoDS_Edge& edge : edges) builder_.AddArgument(edge);
  builder_.SetNonDestructive(true);
  builder_.SetRunParallel(false);
  if (tolerance > 0.0) builder_.SetFuzzyValue(tolerance);
  builder_.Perform();
}

TopTools_ListOfShape FaceFuse::images_of(const TopoDS_Shape& shape) {
  const TopTools_ListOfShape& images = builder_.Modified(shape);
  if (!images.IsEmpty() || builder_.IsDeleted(shape)) return images;
  TopTools_ListOfShape same;
  same.Append(shape);
  return same;
}

TopoDS_Shape FaceFuse::apply(const TopoDS_Shape& solid) {
  if (!exchanged_) exchange_all();
  exchanged_ = true;
  return changes_->Apply(solid);
}

void FaceFuse::exchange_all() {
  for (const TopAbs_ShapeEnum type : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE})
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const TopTools_IndexedMapOfShape parts = sub_shapes(faces_(f), type);
      for (int i = 1; i <= parts.Extent(); ++i) exchange(parts(i).Oriented(TopAbs_FORWARD));
    }
}

void FaceFuse::exchange(const TopoDS_Shape& shape) {
  if (changes_->IsRecorded(shape)) return;
  const TopTools_ListOfShape images = images_of(shape);
  if (images.Extent() == 1 && images.First().IsSame(shape)) return;
  if (shape.ShapeType() == TopAbs_VERTEX) {
    if (!images.IsEmpty()) changes_->Replace(shape, images.First().Oriented(TopAbs_FORWARD));
    return;
  }
  const BRep_Builder builder;
  TopoDS_Shape pieces;
  if (shape.ShapeType() == TopAbs_EDGE) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    pieces = wire;
  } else {
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    pieces = shell;
  }
  for (TopoDS_Shape image : in_order(images)) {
    image.Orientation(turned(image, shape) ? TopAbs_REVERSED : TopAbs_FORWARD);
    if (images.Extent() == 1) {
      changes_->Replace(shape, image);
      return;
    }
    builder.Add(pieces, image);
  }
  changes_->Replace(shape, pieces);
}

bool FaceFuse::turned(TopoDS_Shape image, const TopoDS_Shape& shape) {
  image.Orientation(TopAbs_FORWARD);
  return BOPTools_AlgoTools::IsSplitToReverse(image, shape, context_);
}

}  // namespace octet
