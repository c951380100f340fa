// SPDX-License-Identifier: BSD-3-Clause
// The outside and each void, taken as solids, are fused; what is in no void is the solid.
#include "geom/occt/voids.h"

#include <BRepClass3d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

#include <cmath>

#include "geom/occt/group_fuse.h"
#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

TopoDS_Shape solid_within(const TopoDS_Shape& shell) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// The outside first, then what fills each void; one where there are none, none where no shell is outside.
std::vector<TopoDS_Shape> outside_and_voids(const TopoDS_Shape& solid) {
  const TopoDS_Shape outside = BRepClass3d::OuterShell(TopoDS::Solid(solid));
  if (outside.IsNull()) return {};
  std::vector<TopoDS_Shape> solids{solid_within(outside)};
  for (TopoDS_Iterator it(solid); it.More(); it.Next())
    if (it.Value().ShapeType() == TopAbs_SHELL && !it.Value().IsSame(outside))
      solids.push_back(solid_within(it.Value().Reversed()));
  return solids;
}

/// Whether the fuse changed an edge or a vertex: shells apart from one another keep theirs.
bool any_joined(const TopoDS_Shape& solid, BRepTools_History& history) {
  for (const TopAbs_ShapeEnum type : {TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape entities;
    TopExp::MapShapes(solid, type, entities);
    for (int i = 1; i <= entities.Extent(); ++i)
      if (!history.Modified(entities(i)).IsEmpty()) return true;
  }
  return false;
}

/// Whether a face became several: shells that cross are no matter of edges.
bool any_cut(const TopoDS_Shape& solid, BRepTools_History& history) {
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    if (history.Modified(it.Current()).Extent() > 1) return true;
  return false;
}

/// Whether the solids fill what the one did: by OCCT's integrals, which are off by a little on splines.
bool fill(const std::vector<TopoDS_Shape>& solids, const TopoDS_Shape& solid) {
  constexpr double kShare = 1e-3;
  double volume = -volume_of(solid);
  for (const TopoDS_Shape& made : solids) volume += volume_of(made);
  return std::abs(volume) <= kShare * std::abs(volume_of(solid));
}

/// Whether an edge without length lost its range on a face: a fuse cuts some at their own vertex, where that
/// is touched.
bool any_pole_lost(const std::vector<TopoDS_Shape>& solids) {
  for (const TopoDS_Shape& solid : solids)
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
      for (TopExp_Explorer it(faces.Current(), TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (!BRep_Tool::Degenerated(edge)) continue;
        double first = 0.0, last = 0.0;
        BRep_Tool::CurveOnSurface(edge, TopoDS::Face(faces.Current()), first, last);
        if (!(last - first > Precision::PConfusion())) return true;
      }
  return false;
}

}  // namespace

VoidsJoined join_voids(const TopoDS_Shape& solid) {
  const VoidsJoined same{{solid}, new BRepTools_History, false};
  if (solid.ShapeType() != TopAbs_SOLID) return same;
  const std::vector<TopoDS_Shape> shells = outside_and_voids(solid);
  if (shells.size() < 2) return same;
  const GroupFuse fuse(shells, {}, 0.0, 0.0);
  if (!fuse.sound() || any_cut(solid, *fuse.history()) || !any_joined(solid, *fuse.history())) return same;
  TopTools_MapOfShape voids;
  for (std::size_t i = 1; i < shells.size(); ++i)
    for (const TopoDS_Shape& image : fuse.images()[i]) voids.Add(image);
  VoidsJoined joined{{}, fuse.history(), true};
  for (const TopoDS_Shape& image : fuse.images()[0])
    if (!voids.Contains(image)) joined.solids.push_back(image.Oriented(solid.Orientation()));
  if (joined.solids.empty() || !fill(joined.solids, solid) || any_pole_lost(joined.solids)) return same;
  for (const TopoDS_Shape& made : joined.solids) joined.history->AddModified(solid, made);
  return joined;
}

}  // namespace octet
