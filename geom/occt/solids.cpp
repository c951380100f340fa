// SPDX-License-Identifier: BSD-3-Clause
// The solids of a shape, sewn and fused where the file left them apart.
#include "geom/occt/solids.h"

#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "base/error.h"
#include "geom/occt/sew.h"

namespace octet {
namespace {

/// The faces of `shape` that lie in none of the given solids.
std::vector<TopoDS_Shape> loose_faces(const ShapeMaps& maps, const std::vector<TopoDS_Shape>& solids) {
  TopTools_MapOfShape used;
  for (const TopoDS_Shape& solid : solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) used.Add(it.Current());
  std::vector<TopoDS_Shape> loose;
  for (int i = 1; i <= maps.of[2].Extent(); ++i)
    if (!used.Contains(maps.of[2](i))) loose.push_back(maps.of[2](i));
  return loose;
}

/// A bounded middle point of an edge, by its vertices when it has no curve.
gp_Pnt place_of(const TopoDS_Edge& edge) {
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (!curve.IsNull()) return curve->Value(0.5 * (first + last));
  const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
  return vertex.IsNull() ? gp_Pnt() : BRep_Tool::Pnt(vertex);
}

[[noreturn]] void throw_open(const TopoDS_Shape& shape, const ShapeMaps& maps) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int i = 1; i <= maps.of[1].Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(maps.of[1](i));
    if (BRep_Tool::Degenerated(edge) || !faces_of.Contains(edge)) continue;
    const TopTools_ListOfShape& faces = faces_of.FindFromKey(edge);
    if (faces.Extent() != 1 || BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()))) continue;
    const gp_Pnt at = place_of(edge);
    throw ModelError(
        fmt::format("the part bounds no volume: Edge {} of Face {} is free (at {:.6g}, {:.6g}, {:.6g}); "
                    "close the shell or sew its faces",
                    i, maps.of[2].FindIndex(faces.First()), at.X(), at.Y(), at.Z()),
        model_edge(i));
  }
  throw ModelError("the part bounds no volume: it holds no solid and no closed shell", {});
}

}  // namespace

ShapeMaps::ShapeMaps(const TopoDS_Shape& shape) {
  constexpr TopAbs_ShapeEnum kTypes[4] = {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID};
  for (int dim = 0; dim < 4; ++dim) TopExp::MapShapes(shape, kTypes[dim], of[dim]);
}

TopTools_ListOfShape images_of(const TopoDS_Shape& shape, const SolidSet& set) {
  TopTools_ListOfShape images;
  if (BRepTools_History::IsSupportedType(shape)) images = set.history->Modified(shape);
  if (images.IsEmpty() && !set.history->IsRemoved(shape)) images.Append(shape);
  return images;
}

SolidSet collect_solids(const TopoDS_Shape& shape, const ShapeMaps& as_read, double sew_tolerance) {
  SolidSet set;
  set.history = new BRepTools_History();
  for (int i = 1; i <= as_read.of[3].Extent(); ++i)
    if (TopExp_Explorer(as_read.of[3](i), TopAbs_FACE).More()) set.solids.push_back(as_read.of[3](i));
  const auto shells = solids_from_shells(shape);
  if (!shells.empty()) {
    set.notes.push_back(fmt::format("{} closed shell(s) taken as solid(s)", shells.size()));
    set.solids.insert(set.solids.end(), shells.begin(), shells.end());
  }
  const auto loose = loose_faces(as_read, set.solids);
  if (!loose.empty()) {
    const Sewn sewn = sew_faces(loose, sew_tolerance);
    if (!sewn.solids.empty()) {
      set.history->Merge(sewn.history);
      set.notes.push_back(fmt::format(
          "{} loose faces sewn with tolerance {:.3g} mm into {} closed shell(s); {} free edge(s) left",
          loose.size(), sewn.tolerance, sewn.solids.size(), sewn.free_edges));
      set.solids.insert(set.solids.end(), sewn.solids.begin(), sewn.solids.end());
    }
  }
  if (set.solids.empty()) throw_open(shape, as_read);
  return set;
}

}  // namespace octet
