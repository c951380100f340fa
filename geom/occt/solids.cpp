// SPDX-License-Identifier: BSD-3-Clause
// The solids of a shape, sewn and fused where the file left them apart.
#include "geom/occt/solids.h"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>

#include "base/error.h"

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

TopoDS_Shape solid_from_shell(const TopoDS_Shape& shell) {
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell.Oriented(TopAbs_FORWARD));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

/// Closed shells of `shape` outside its solids, as solids.
std::vector<TopoDS_Shape> solids_from_shells(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> solids;
  TopTools_MapOfShape seen;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
    if (seen.Add(it.Current()) && BRep_Tool::IsClosed(it.Current()))
      solids.push_back(solid_from_shell(it.Current()));
  return solids;
}

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
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

/// Sews with growing tolerance until shells close. The largest tolerance is a ten-thousandth of the part:
/// above that sewing joins what is meant to be apart.
std::vector<TopoDS_Shape> sew(const std::vector<TopoDS_Shape>& faces, SolidSet& set) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& face : faces) builder.Add(compound, face);
  const double diagonal = diagonal_of(compound);
  std::vector<TopoDS_Shape> best;
  std::size_t best_free = faces.size() * 1000;
  Handle(BRepTools_History) best_history;
  double best_tolerance = 0.0;
  for (const double share : {1e-7, 1e-6, 1e-5, 1e-4}) {
    BRepBuilderAPI_Sewing sewing(share * diagonal);
    sewing.Add(compound);
    sewing.Perform();
    const auto solids = solids_from_shells(sewing.SewedShape());
    const auto free = static_cast<std::size_t>(sewing.NbFreeEdges());
    if (solids.empty() || free >= best_free) continue;
    best = solids;
    best_free = free;
    best_tolerance = share * diagonal;
    best_history = new BRepTools_History();
    add_history(sewing, compound, *best_history);
    if (free == 0) break;
  }
  if (best.empty()) return best;
  set.history->Merge(best_history);
  set.notes.push_back(fmt::format(
      "{} loose faces sewn with tolerance {:.3g} mm into {} closed shell(s); {} free edge(s) left",
      faces.size(), best_tolerance, best.size(), best_free));
  return best;
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

void note_left_out(const ShapeMaps& maps, SolidSet& set) {
  TopTools_MapOfShape used;
  for (const TopoDS_Shape& solid : set.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) used.Add(it.Current());
  int count = 0, first = 0;
  for (int i = 1; i <= maps.of[2].Extent(); ++i) {
    const TopoDS_Shape& face = maps.of[2](i);
    bool found = used.Contains(face);
    for (const TopoDS_Shape& image : set.history->Modified(face)) found = found || used.Contains(image);
    if (found) continue;
    if (count++ == 0) first = i;
  }
  if (count > 0)
    set.notes.push_back(fmt::format(
        "{} face(s) bound no volume and are left out, the first is Face {} as read", count, first));
}

}  // namespace

ShapeMaps::ShapeMaps(const TopoDS_Shape& shape) {
  constexpr TopAbs_ShapeEnum kTypes[4] = {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID};
  for (int dim = 0; dim < 4; ++dim) TopExp::MapShapes(shape, kTypes[dim], of[dim]);
}

SolidSet collect_solids(const TopoDS_Shape& shape, const ShapeMaps& as_read) {
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
    const auto sewn = sew(loose, set);
    set.solids.insert(set.solids.end(), sewn.begin(), sewn.end());
  }
  if (set.solids.empty()) throw_open(shape, as_read);
  note_left_out(as_read, set);
  return set;
}

}  // namespace octet
