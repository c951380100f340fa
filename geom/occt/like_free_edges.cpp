// SPDX-License-Identifier: BSD-3-Clause
// Pairs are looked for among the edges of the same vertices.
#include "geom/occt/like_free_edges.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt2d.hxx>
#include <gp_Vec2d.hxx>
#include <optional>
#include <vector>

#include "geom/occt/free_edges.h"
#include "geom/occt/same_place.h"

namespace octet {
namespace {

bool same_ends(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Vertex a0 = TopExp::FirstVertex(a), a1 = TopExp::LastVertex(a), b0 = TopExp::FirstVertex(b),
                      b1 = TopExp::LastVertex(b);
  if (a0.IsNull() || a1.IsNull() || b0.IsNull() || b1.IsNull()) return false;
  return (a0.IsSame(b0) && a1.IsSame(b1)) || (a0.IsSame(b1) && a1.IsSame(b0));
}

gp_Pnt2d middle_on(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  return curve.IsNull() ? gp_Pnt2d() : curve->Value(0.5 * (first + last));
}

/// Two edges of one face are its seam where it lies between their curves on it; else it has a slit there.
bool are_a_seam(const TopoDS_Edge& one, const TopoDS_Edge& other, const TopoDS_Face& face) {
  constexpr double kBetween = 0.9;
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const gp_Vec2d apart(middle_on(one, face), middle_on(other, face));
  return std::abs(apart.X()) > kBetween * (u1 - u0) || std::abs(apart.Y()) > kBetween * (v1 - v0);
}

/// A copy with the same vertices and curves: the shapes that were sewn may have the edge as well.
TopoDS_Edge copy_of(const TopoDS_Edge& edge) {
  const BRep_Builder builder;
  TopoDS_Edge copy = TopoDS::Edge(edge.EmptyCopied());
  for (TopoDS_Iterator it(edge); it.More(); it.Next()) builder.Add(copy, it.Value());
  return copy;
}

bool is_forward_in(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().IsSame(edge)) return it.Current().Orientation() == TopAbs_FORWARD;
  return false;
}

/// Gives the seam, which has a curve on the face for the one side (its forward use, or else the other), that
/// of `other`, too.
void make_seam(const TopoDS_Edge& seam, bool forward, const TopoDS_Edge& other, const TopoDS_Face& face,
               bool along) {
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) own = BRep_Tool::CurveOnSurface(seam, face, first, last);
  take_curve(other, face, seam, along);
  const Handle(Geom2d_Curve) taken = BRep_Tool::CurveOnSurface(seam, face, first, last);
  const BRep_Builder builder;
  builder.UpdateEdge(seam, forward ? own : taken, forward ? taken : own, face, BRep_Tool::Tolerance(seam));
}

}  // namespace

std::size_t join_like_free_edges(const TopoDS_Shape& shape, double near, BRepTools_ReShape& changes) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of, edges_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  const std::vector<TopoDS_Edge> edges = free_edges(shape);
  for (const TopoDS_Edge& edge : edges)
    TopExp::MapShapesAndUniqueAncestors(edge.Oriented(TopAbs_FORWARD), TopAbs_VERTEX, TopAbs_EDGE, edges_of);
  const BRep_Builder builder;
  TopTools_MapOfShape done;
  std::size_t pairs = 0;
  for (const TopoDS_Edge& edge : edges) {
    const TopoDS_Edge kept = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex start = TopExp::FirstVertex(kept);
    if (start.IsNull() || done.Contains(kept)) continue;
    for (const TopoDS_Shape& there : edges_of.FindFromKey(start)) {
      const TopoDS_Edge other = TopoDS::Edge(there);
      const TopoDS_Face face = TopoDS::Face(faces_of.FindFromKey(other).First());
      if (other.IsSame(kept) || done.Contains(other) || !same_ends(kept, other)) continue;
      const std::optional<bool> along = same_way(kept, other, near);
      const bool within = faces_of.FindFromKey(kept).First().IsSame(face);
      if (!along || (within && !are_a_seam(kept, other, face))) continue;
      const TopoDS_Edge both = copy_of(kept);
      builder.UpdateEdge(both, std::max(near, BRep_Tool::Tolerance(other)));
      if (within)
        make_seam(both, is_forward_in(face, kept), other, face, *along);
      else
        take_curve(other, face, both, *along);
      changes.Replace(kept, both);
      changes.Replace(other, both.Oriented(*along ? TopAbs_FORWARD : TopAbs_REVERSED));
      done.Add(kept);
      done.Add(other);
      ++pairs;
      break;
    }
  }
  return pairs;
}

}  // namespace octet
