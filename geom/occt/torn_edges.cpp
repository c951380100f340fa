// SPDX-License-Identifier: BSD-3-Clause
// The ends of the curve against the vertices.
#include "geom/occt/torn_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

namespace octet {

bool is_torn(const TopoDS_Edge& edge, double near, double share) {
  double first = 0.0, last = 0.0;
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  if (BRep_Tool::Degenerated(edge) || BRep_Tool::Curve(forward, first, last).IsNull()) return false;
  const BRepAdaptor_Curve curve(forward);
  const double leeway = std::max(near, share * curve.Value(first).Distance(curve.Value(last)));
  const auto gap = [](const TopoDS_Vertex& vertex, const gp_Pnt& end) {
    return vertex.IsNull() ? 0.0 : BRep_Tool::Pnt(vertex).Distance(end);
  };
  return gap(TopExp::FirstVertex(forward), curve.Value(first)) > leeway ||
         gap(TopExp::LastVertex(forward), curve.Value(last)) > leeway;
}

}  // namespace octet
