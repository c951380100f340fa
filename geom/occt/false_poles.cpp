// SPDX-License-Identifier: BSD-3-Clause
// Points along the curve on the face, held against the first.
#include "geom/occt/false_poles.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>

#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Whether the face leaves a point along the edge, by more than a hundredth of its own size. (The vertex
/// proves nothing: its tolerance has been made to hold all of the line.)
bool has_length(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kPieces = 8;
  constexpr double kShare = 0.01;
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return false;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const auto at = [&](int i) {
    const gp_Pnt2d uv = curve->Value(first + (last - first) * i / kPieces);
    return surface->Value(uv.X(), uv.Y());
  };
  double farthest = 0.0;
  for (int i = 1; i <= kPieces; ++i) farthest = std::max(farthest, at(0).Distance(at(i)));
  return farthest > Precision::Confusion() && farthest > kShare * diagonal_of(box_of(face));
}

}  // namespace

Repair drop_false_poles(const TopoDS_Shape& solid) {
  Repair result = no_repair(solid);
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    bool any = false;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (!BRep_Tool::Degenerated(edge) || !has_length(edge, face)) continue;
      changes->Remove(edge);
      any = true;
    }
    if (any) result.entities.push_back(faces(i));
  }
  if (result.entities.empty()) return result;
  result.solid = changes->Apply(solid);
  result.history->Merge(changes->History());
  return result;
}

}  // namespace octet
