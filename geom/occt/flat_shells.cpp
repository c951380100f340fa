// SPDX-License-Identifier: BSD-3-Clause
// Shells are weighed one by one.
#include "geom/occt/flat_shells.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

bool is_flat(const TopoDS_Shape& shell, double thickness) {
  for (TopExp_Explorer it(shell, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      thickness = std::max(thickness, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  try {
    return 2.0 * std::abs(volume_of(shell)) <= thickness * area_of(shell);
  } catch (const Standard_Failure&) {  // OCCT cannot tell
    return false;
  }
}

}  // namespace

Repair drop_flat_shells(const TopoDS_Shape& solid, double thickness) {
  std::vector<TopoDS_Shape> flat;
  TopoDS_Solid made;
  const BRep_Builder builder;
  builder.MakeSolid(made);
  bool any = false;
  if (sub_shapes(solid, TopAbs_SHELL).Extent() > 1)
    for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
      const TopoDS_Shape& part = it.Value();
      if (part.ShapeType() == TopAbs_SHELL && BRep_Tool::IsClosed(part) && is_flat(part, thickness)) {
        flat.push_back(part);
      } else {
        builder.Add(made, part);
        any = any || part.ShapeType() == TopAbs_SHELL;
      }
    }
  Repair result = no_repair(solid);
  if (flat.empty() || !any) return result;
  for (const TopoDS_Shape& shell : flat)
    for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      const TopTools_IndexedMapOfShape kept = sub_shapes(made, type), gone = sub_shapes(shell, type);
      for (int i = 1; i <= gone.Extent(); ++i) {
        if (kept.Contains(gone(i))) continue;
        result.history->Remove(gone(i));
        if (type == TopAbs_FACE) result.entities.push_back(gone(i));
      }
    }
  result.solid = made;
  return result;
}

}  // namespace octet
