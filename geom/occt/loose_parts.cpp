// SPDX-License-Identifier: BSD-3-Clause
// Edges with an end to themselves, again and again: taking one away may leave the next such an end.
#include "geom/occt/loose_parts.h"

#include <BRepTools_ReShape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>

#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

using Shapes = std::vector<TopoDS_Shape>;

/// Whether a face or an edge has the part inside: along no loop, at no end.
bool is_inside(const TopoDS_Shape& part) { return part.Orientation() == TopAbs_INTERNAL; }

/// The vertices that are ends of edges.
TopTools_MapOfShape ends_in(const Shapes& shapes) {
  TopTools_MapOfShape ends;
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next())
      for (TopoDS_Iterator it(edge.Current(), false); it.More(); it.Next())
        if (!is_inside(it.Value())) ends.Add(it.Value());
  return ends;
}

/// Vertices inside of edges and faces, at the end of no edge, that are not among those before.
Shapes loose_vertices(const Shapes& shapes, const TopTools_IndexedMapOfShape& before) {
  const TopTools_MapOfShape ends = ends_in(shapes);
  Shapes loose;
  for (const TopoDS_Shape& shape : shapes)
    for (const TopAbs_ShapeEnum type : {TopAbs_EDGE, TopAbs_FACE})
      for (TopExp_Explorer around(shape, type); around.More(); around.Next())
        for (TopoDS_Iterator it(around.Current(), false); it.More(); it.Next()) {
          const TopoDS_Shape& part = it.Value();
          if (part.ShapeType() != TopAbs_VERTEX || ends.Contains(part) || before.Contains(part)) continue;
          loose.push_back(part);
        }
  return loose;
}

/// The edges that lie inside of one face and are in no other.
TopTools_IndexedMapOfShape edges_in_one_face(const Shapes& shapes) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopTools_MapOfShape on_loops;
  for (const TopoDS_Shape& shape : shapes) {
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
      if (!is_inside(it.Current())) on_loops.Add(it.Current());
  }
  TopTools_IndexedMapOfShape found;
  for (int i = 1; i <= faces_of.Extent(); ++i)
    if (faces_of(i).Extent() == 1 && !on_loops.Contains(faces_of.FindKey(i))) found.Add(faces_of.FindKey(i));
  return found;
}

/// Of those edges the ones that end nowhere, or would without others that do.
Shapes loose_edges(const Shapes& shapes, const TopTools_IndexedMapOfShape& before) {
  TopTools_IndexedDataMapOfShapeListOfShape edges_of;
  for (const TopoDS_Shape& shape : shapes)
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges_of);
  const TopTools_IndexedMapOfShape candidates = edges_in_one_face(shapes);
  TopTools_MapOfShape gone;
  const auto is_end = [&](const TopoDS_Shape& vertex) {
    if (before.Contains(vertex)) return false;
    int left = 0;
    for (const TopoDS_Shape& edge : edges_of.FindFromKey(vertex)) left += gone.Contains(edge) ? 0 : 1;
    return left == 1;
  };
  Shapes loose;
  for (bool more = true; more;) {
    more = false;
    for (int i = 1; i <= candidates.Extent(); ++i) {
      const TopTools_IndexedMapOfShape vertices = sub_shapes(candidates(i), TopAbs_VERTEX);
      if (gone.Contains(candidates(i)) || vertices.Extent() < 2) continue;
      if (!is_end(vertices(1)) && !is_end(vertices(2))) continue;
      gone.Add(candidates(i));
      loose.push_back(candidates(i));
      more = true;
    }
  }
  return loose;
}

/// The wires that have no edge but those that go.
Shapes empty_wires(const Shapes& shapes, const Shapes& edges) {
  Shapes found;
  for (const TopoDS_Shape& shape : shapes)
    for (TopExp_Explorer wire(shape, TopAbs_WIRE); wire.More(); wire.Next()) {
      bool empty = true;
      for (TopoDS_Iterator it(wire.Current()); it.More() && empty; it.Next())
        empty = std::any_of(edges.begin(), edges.end(),
                            [&](const TopoDS_Shape& edge) { return edge.IsSame(it.Value()); });
      if (empty) found.push_back(wire.Current());
    }
  return found;
}

}  // namespace

void drop_loose_parts(const Shapes& solids, std::vector<Shapes>& images,
                      const Handle(BRepTools_History) & history) {
  TopTools_IndexedMapOfShape before;
  for (const TopoDS_Shape& solid : solids) TopExp::MapShapes(solid, TopAbs_VERTEX, before);
  Shapes all;
  for (const Shapes& own : images) all.insert(all.end(), own.begin(), own.end());
  const Shapes edges = loose_edges(all, before), vertices = loose_vertices(all, before);
  if (edges.empty() && vertices.empty()) return;
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  for (const Shapes& parts : {empty_wires(all, edges), edges, vertices})
    for (const TopoDS_Shape& part : parts) changes->Remove(part);
  for (Shapes& own : images)
    for (TopoDS_Shape& image : own) image = changes->Apply(image);
  history->Merge(changes->History());
  // What was no image of anything but itself is not in the history yet, though it may be another's image.
  for (const TopoDS_Shape& solid : solids)
    for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE}) {
      const TopTools_IndexedMapOfShape parts = sub_shapes(solid, type);
      for (int i = 1; i <= parts.Extent(); ++i) {
        if (history->IsRemoved(parts(i)) || !history->Modified(parts(i)).IsEmpty()) continue;
        const TopoDS_Shape now = changes->Apply(parts(i));
        if (!now.IsNull() && !now.IsSame(parts(i))) history->AddModified(parts(i), now);
      }
    }
}

}  // namespace octet
