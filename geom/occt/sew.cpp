// SPDX-License-Identifier: BSD-3-Clause
// Loose faces sewn to closed shells.
#include "geom/occt/sew.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeFix_Shell.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <utility>

#include "geom/occt/free_edges.h"
#include "geom/occt/gathered.h"
#include "geom/occt/like_free_edges.h"
#include "geom/occt/loose_bodies.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/shell_solids.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

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

/// The faces, sorted into shells that hang together and are turned alike.
TopoDS_Shape shells_of(const std::vector<TopoDS_Shape>& faces) {
  ShapeFix_Shell fix;
  fix.FixFaceOrientation(shell_of(faces));
  return fix.Shape();
}

/// What sewing has left beside each other.
void join_what_is_left(const TopoDS_Compound& compound, Sewn& sewn) {
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  const std::size_t joined = join_like_free_edges(sewn.shape, sewn.tolerance, *changes);
  if (joined == 0) return;
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(sewn.shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(changes->Apply(it.Current()));
  sewn.shape = shells_of(faces);
  sewn.free_edges = free_edges(sewn.shape).size();
  const Handle(BRepTools_History) all = new BRepTools_History();
  for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape parts = sub_shapes(compound, type);
    for (int i = 1; i <= parts.Extent(); ++i) {
      TopTools_ListOfShape images = sewn.history->Modified(parts(i));
      if (images.IsEmpty()) images.Append(parts(i));
      for (const TopoDS_Shape& image : images)
        if (const TopoDS_Shape now = changes->Apply(image); !now.IsSame(parts(i)))
          all->AddModified(parts(i), now);
    }
  }
  sewn.history = all;
}

Sewn sewn_at_once(const TopoDS_Compound& compound, double tolerance) {
  BRepBuilderAPI_Sewing sewing(tolerance);
  sewing.Add(compound);
  sewing.Perform();
  Sewn sewn;
  sewn.shape = sewing.SewedShape();
  sewn.free_edges = static_cast<std::size_t>(sewing.NbFreeEdges());
  sewn.tolerance = tolerance;
  sewn.history = new BRepTools_History();
  add_history(sewing, compound, *sewn.history);
  join_what_is_left(compound, sewn);
  sewn.solids = solids_from_shells(sewn.shape);
  return sewn;
}

Sewn sewn_one_by_one(const std::vector<std::vector<TopoDS_Shape>>& bodies, double tolerance) {
  Sewn sewn;
  sewn.tolerance = tolerance;
  sewn.history = new BRepTools_History();
  std::vector<TopoDS_Shape> shapes;
  for (const std::vector<TopoDS_Shape>& body : bodies) {
    const Sewn one = sewn_at_once(compound_of(body), tolerance);
    sewn.history->Merge(one.history);
    sewn.free_edges += one.free_edges;
    shapes.push_back(one.shape);
  }
  sewn.shape = compound_of(shapes);
  sewn.solids = solids_from_shells(sewn.shape);
  return sewn;
}

/// Body by body, if faces stand so that it can be told which they are: bodies may touch. Edges have
/// tolerances of their own, within which faces are sewn as well: which edges are alike is told to a hundred
/// times the tolerance, where all bodies then close.
Sewn sewn_within(const LooseBodies& loose, const TopoDS_Compound& all, double tolerance) {
  for (const double looser : {1.0, 10.0, 100.0}) {
    const std::vector<std::vector<TopoDS_Shape>> bodies = loose.in_order(looser * tolerance);
    if (bodies.empty()) continue;
    Sewn sewn = sewn_one_by_one(bodies, tolerance);
    if (looser == 1.0 || sewn.free_edges == 0) return sewn;
  }
  return sewn_at_once(all, tolerance);
}

/// The tolerances of the cap's edges and vertices become as wide as these lie off it.
void widen(const Cap& cap) {
  const BRep_Builder builder;
  for (const TopoDS_Edge& edge : cap.edges) {
    builder.UpdateEdge(edge, cap.off);
    for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next())
      builder.UpdateVertex(TopoDS::Vertex(it.Current()), BRep_Tool::Tolerance(edge));
  }
}

/// A shell that encloses nothing, but for its tolerance.
bool is_flat(const TopoDS_Shape& shell, double tolerance) {
  return std::abs(volume_of(shell)) <= tolerance * std::abs(area_of(shell));
}

TopTools_MapOfShape faces_in(const std::vector<TopoDS_Shape>& shapes) {
  TopTools_MapOfShape faces;
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.Add(it.Current());
  return faces;
}

using FacesOfEdges = TopTools_IndexedDataMapOfShapeListOfShape;

/// Whether no other face has an edge of the shell: what hangs on one is no part of a skin, and which faces of
/// three at an edge bound something is a guess.
bool is_whole(const TopoDS_Shape& shell, const FacesOfEdges& faces_of) {
  const TopTools_MapOfShape faces = faces_in({shell});
  for (TopExp_Explorer it(shell, TopAbs_EDGE); it.More(); it.Next())
    for (const TopoDS_Shape& face : faces_of.FindFromKey(it.Current()))
      if (!faces.Contains(face)) return false;
  return true;
}

/// Caps what is open. Of the shells that it closes those that enclose nothing are left as they were.
void cap_openings(Sewn& sewn) {
  const TopTools_MapOfShape closed = faces_in(sewn.solids);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(sewn.shape, TopAbs_FACE); it.More(); it.Next())
    if (!closed.Contains(it.Current())) faces.push_back(it.Current());
  const std::vector<Cap> caps = planar_caps(compound_of(faces), sewn.tolerance);
  if (caps.empty()) return;
  for (const Cap& cap : caps) faces.push_back(cap.face);
  FacesOfEdges faces_of;
  TopExp::MapShapesAndAncestors(compound_of(faces), TopAbs_EDGE, TopAbs_FACE, faces_of);
  std::vector<TopoDS_Shape> solids, flat;
  for (const TopoDS_Shape& solid : solids_from_shells(shells_of(faces))) {
    if (is_flat(solid, sewn.tolerance))
      flat.push_back(solid);
    else if (is_whole(solid, faces_of))
      solids.push_back(solid);
  }
  const TopTools_MapOfShape used = faces_in(solids), in_flat = faces_in(flat);
  std::vector<TopoDS_Shape> all{sewn.shape};
  for (const Cap& cap : caps) {
    if (in_flat.Contains(cap.face)) continue;
    all.push_back(cap.face);
    if (!used.Contains(cap.face)) {
      ++sewn.caps_left;
      continue;
    }
    widen(cap);
    sewn.caps.push_back(cap);
  }
  sewn.shape = compound_of(all);
  sewn.free_edges = free_edges(sewn.shape).size();
  sewn.solids.insert(sewn.solids.end(), solids.begin(), solids.end());
}

}  // namespace

Sewn sew_faces(const std::vector<TopoDS_Shape>& faces, const SewOptions& options) {
  const TopoDS_Compound compound = compound_of(faces);
  std::vector<double> tolerances = {options.tolerance};
  if (options.tolerance <= 0.0) {
    const double diagonal = diagonal_of(box_of(compound));
    tolerances = {1e-7 * diagonal, 1e-6 * diagonal, 1e-5 * diagonal, 1e-4 * diagonal};
  }
  Sewn best;
  const LooseBodies loose(faces);
  for (const double reach : tolerances) {
    const Sewn sewn = sewn_within(loose, compound, reach);
    const bool worse =
        std::pair(sewn.solids.empty(), sewn.free_edges) >= std::pair(best.solids.empty(), best.free_edges);
    if (best.shape.IsNull() || !worse) best = sewn;
    if (best.free_edges == 0 && !best.solids.empty()) break;
  }
  if (options.cap && !best.shape.IsNull() && best.free_edges > 0) cap_openings(best);
  return best;
}

}  // namespace octet
