// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of a solid close along its edges.
#include "geom/occt/edge_uses.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

namespace octet {

int EdgeUses::first(bool (Uses::*wrong)() const) const {
  for (std::size_t i = 1; i < uses.size(); ++i)
    if ((uses[i].*wrong)()) return static_cast<int>(i);
  return 0;
}

EdgeUses edge_uses(const TopoDS_Shape& solid) {
  EdgeUses result;
  result.uses.resize(1);
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopAbs_Orientation way = faces.Current().Orientation();
    if (way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL) continue;
    for (TopExp_Explorer it(faces.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      const auto index = static_cast<std::size_t>(result.edges.Add(edge));
      if (index == result.uses.size()) result.uses.emplace_back();
      result.uses[index].forward += edge.Orientation() == TopAbs_FORWARD ? 1 : 0;
      result.uses[index].reversed += edge.Orientation() == TopAbs_REVERSED ? 1 : 0;
    }
  }
  return result;
}

}  // namespace octet
