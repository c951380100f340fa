// SPDX-License-Identifier: BSD-3-Clause
// Loose faces sewn to closed shells.
#include "geom/occt/sew.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <utility>

#include "geom/occt/shape_box.h"

namespace octet {
namespace {

TopoDS_Shape solid_from_shell(const TopoDS_Shape& shell) {
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell.Oriented(TopAbs_FORWARD));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

void add_history(const BRepBuilderAPI_Sewing& sewing, const TopoDS_Shape& compound,
                 BRepTools_History& history) {
  for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(compound, type, map);
    for (int i = 1; i <= map.Extent(); ++i) {
      const TopoDS_Shape image =
          sewing.IsModified(map(i)) ? sewing.Modified(map(i)) : sewing.ModifiedSubShape(map(i));
      if (image.IsNull() || image.IsSame(map(i))) continue;
      for (TopExp_Explorer it(image, type); it.More(); it.Next()) history.AddModified(map(i), it.Current());
    }
  }
}

}  // namespace

std::vector<TopoDS_Shape> solids_from_shells(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> solids;
  TopTools_MapOfShape seen;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
    if (seen.Add(it.Current()) && BRep_Tool::IsClosed(it.Current()))
      solids.push_back(solid_from_shell(it.Current()));
  return solids;
}

Sewn sew_faces(const std::vector<TopoDS_Shape>& faces, double tolerance) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& face : faces) builder.Add(compound, face);
  std::vector<double> tolerances = {tolerance};
  if (tolerance <= 0.0) {
    const double diagonal = diagonal_of(box_of(compound));
    tolerances = {1e-7 * diagonal, 1e-6 * diagonal, 1e-5 * diagonal, 1e-4 * diagonal};
  }
  Sewn best;
  for (const double reach : tolerances) {
    BRepBuilderAPI_Sewing sewing(reach);
    sewing.Add(compound);
    sewing.Perform();
    const auto solids = solids_from_shells(sewing.SewedShape());
    const auto free = static_cast<std::size_t>(sewing.NbFreeEdges());
    const bool worse = std::pair(solids.empty(), free) >= std::pair(best.solids.empty(), best.free_edges);
    if (!best.shape.IsNull() && worse) continue;
    best.shape = sewing.SewedShape();
    best.solids = solids;
    best.free_edges = free;
    best.tolerance = reach;
    best.history = new BRepTools_History();
    add_history(sewing, compound, *best.history);
    if (free == 0 && !solids.empty()) break;
  }
  return best;
}

}  // namespace octet
