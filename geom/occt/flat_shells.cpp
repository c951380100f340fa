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
  Repair result = no_repair(solid);
  const TopTools_IndexedMapOfShape shells = sub_shapes(solid, TopAbs_SHELL);
  if (shells.Extent() < 2) return result;
  TopTools_IndexedMapOfShape flat;
  for (int i = 1; i <= shells.Extent(); ++i)
    if (BRep_Tool::IsClosed(shells(i)) && is_flat(shells(i), thickness)) flat.Add(shells(i));
  if (flat.IsEmpty() || flat.Extent() == shells.Extent()) return result;
  TopoDS_Solid made;
  const BRep_Builder builder;
  builder.MakeSolid(made);
  for (TopoDS_Iterator it(solid); it.More(); it.Next())
    if (!flat.Contains(it.Value())) builder.Add(made, it.Value());
  result.solid = made;
  for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape all = sub_shapes(solid, type), kept = sub_shapes(made, type);
    for (int i = 1; i <= all.Extent(); ++i) {
      if (kept.Contains(all(i))) continue;
      result.history->Remove(all(i));
      if (type == TopAbs_FACE) result.entities.push_back(all(i));
    }
  }
  return result;
}

}  // namespace octet
