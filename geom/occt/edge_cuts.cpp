// SPDX-License-Identifier: BSD-3-Clause
// Pieces keep the curve and take ranges of it.
#include "geom/occt/edge_cuts.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

namespace octet {
namespace {

/// The edge in pieces, from its first vertex to its last.
TopoDS_Wire pieces_of(const TopoDS_Edge& edge, const std::vector<Cut>& cuts) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  double from = 0.0, last = 0.0;
  BRep_Tool::Range(edge, from, last);
  TopoDS_Vertex start = TopExp::FirstVertex(edge);
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    const bool ends = i == cuts.size();
    const double to = ends ? last : cuts[i].parameter;
    const TopoDS_Vertex end = ends ? TopExp::LastVertex(edge) : cuts[i].vertex;
    TopoDS_Edge piece = TopoDS::Edge(edge.EmptyCopied());
    builder.Add(piece, start.Oriented(TopAbs_FORWARD));
    builder.Add(piece, end.Oriented(TopAbs_REVERSED));
    builder.Range(piece, from, to);
    builder.Add(wire, piece);
    from = to;
    start = end;
  }
  return wire;
}

}  // namespace

void EdgeCuts::add(int edge, const Cut& cut) {
  std::vector<Cut>& cuts = cuts_[edge];
  for (const Cut& known : cuts)
    if (known.vertex.IsSame(cut.vertex) || known.parameter == cut.parameter) return;
  cuts.push_back(cut);
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter < b.parameter; });
}

Repair EdgeCuts::apply(const TopoDS_Shape& solid, const TopTools_IndexedMapOfShape& edges) const {
  Repair result = no_repair(solid);
  if (cuts_.empty()) return result;
  const BRep_Builder builder;
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  for (const auto& [number, cuts] : cuts_) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(number).Oriented(TopAbs_FORWARD));
    for (const Cut& cut : cuts) builder.UpdateVertex(cut.vertex, cut.distance);
    changes->Replace(edge, pieces_of(edge, cuts));
    result.entities.push_back(edge);
  }
  result.solid = changes->Apply(solid);
  result.history = changes->History();
  return result;
}

}  // namespace octet
