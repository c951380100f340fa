// SPDX-License-Identifier: BSD-3-Clause
// One of the faces, with its edges and vertices, takes the others' places.
#include "geom/occt/common_faces.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools_History.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <set>
#include <utility>

#include "geom/occt/edge_uses.h"
#include "geom/occt/gathered.h"
#include "geom/occt/like_faces.h"
#include "geom/occt/same_place.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

void add_change(BRepTools_History& history, const TopoDS_Shape& was, const TopoDS_Shape& is) {
  if (!is.IsSame(was) && history.Modified(was).IsEmpty()) history.AddModified(was, is);
}

/// The solids, with faces, edges and vertices taken from others where they are alike.
class Joined {
 public:
  Joined(const std::vector<TopoDS_Shape>& solids, const std::vector<LikeFaces>& alike)
      : changes_(new BRepTools_ReShape) {
    for (const TopoDS_Shape& solid : solids)
      TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_);
    for (const LikeFaces& pair : alike) gone_.Add(pair.other);
    for (const LikeFaces& pair : alike) {
      for (const LikeEdges& edges : pair.edges) take(edges);
      const TopoDS_Shape kept = last(pair.kept);
      replace(pair.other, pair.same_side ? kept : kept.Reversed());
    }
    for (const TopoDS_Shape& solid : solids) solids_.push_back(changes_->Apply(solid));
  }

  [[nodiscard]] const std::vector<TopoDS_Shape>& solids() const { return solids_; }
  /// What became of the faces, edges and vertices of a solid.
  void add_to(BRepTools_History& history, const TopoDS_Shape& was) {
    for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      const TopTools_IndexedMapOfShape map = sub_shapes(was, type);
      for (int k = 1; k <= map.Extent(); ++k) add_change(history, map(k), changes_->Apply(map(k)));
    }
  }

 private:
  /// What stands for the shape now, as the shape is turned.
  [[nodiscard]] TopoDS_Shape last(TopoDS_Shape shape) const {
    while (const TopoDS_Shape* next = becomes_.Seek(shape))
      shape = next->Oriented(TopAbs::Compose(shape.Orientation(), next->Orientation()));
    return shape;
  }

  /// `by` is turned as it is to be where `other` is forward or, for both being turned, reversed.
  void replace(const TopoDS_Shape& other, const TopoDS_Shape& by) {
    const TopAbs_Orientation way = other.Orientation() == by.Orientation() ? TopAbs_FORWARD : TopAbs_REVERSED;
    becomes_.Bind(other, by.Oriented(way));
    changes_->Replace(other.Oriented(TopAbs_FORWARD), by.Oriented(way));
  }

  void take(const LikeEdges& edges) {
    if (becomes_.IsBound(edges.other)) return;
    const TopoDS_Edge kept = TopoDS::Edge(last(edges.kept.Oriented(TopAbs_FORWARD)));
    if (kept.IsSame(edges.other)) return;
    const bool along = edges.along == (kept.Orientation() == TopAbs_FORWARD);
    const TopoDS_Edge bare = TopoDS::Edge(kept.Oriented(TopAbs_FORWARD));
    const BRep_Builder builder;
    builder.UpdateEdge(bare, nearest_tolerance(bare, edges.other));
    for (const TopoDS_Shape& face : faces_of_.FindFromKey(edges.other))
      if (!gone_.Contains(face)) take_curve(edges.other, TopoDS::Face(face), bare, along);
    const TopoDS_Edge other = TopoDS::Edge(edges.other.Oriented(TopAbs_FORWARD));
    take_vertex(TopExp::FirstVertex(bare), along ? TopExp::FirstVertex(other) : TopExp::LastVertex(other));
    take_vertex(TopExp::LastVertex(bare), along ? TopExp::LastVertex(other) : TopExp::FirstVertex(other));
    replace(other, bare.Oriented(along ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  /// What holds the other's curves on faces, too: these may be as far as the other's tolerance from it.
  static double nearest_tolerance(const TopoDS_Edge& kept, const TopoDS_Edge& other) {
    return std::max(BRep_Tool::Tolerance(kept), 2.0 * BRep_Tool::Tolerance(other));
  }

  void take_vertex(const TopoDS_Vertex& vertex, const TopoDS_Vertex& other) {
    if (vertex.IsNull() || other.IsNull() || becomes_.IsBound(other)) return;
    const TopoDS_Vertex kept = TopoDS::Vertex(last(vertex).Oriented(TopAbs_FORWARD));
    if (kept.IsSame(other)) return;
    const BRep_Builder builder;
    builder.UpdateVertex(kept,
                         BRep_Tool::Tolerance(other) + BRep_Tool::Pnt(kept).Distance(BRep_Tool::Pnt(other)));
    replace(other.Oriented(TopAbs_FORWARD), kept);
  }

  Handle(BRepTools_ReShape) changes_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_;
  TopTools_MapOfShape gone_;  ///< faces that others stand for
  TopTools_DataMapOfShapeShape becomes_;
  std::vector<TopoDS_Shape> solids_;
};

bool is_closed(const TopoDS_Shape& solid) { return edge_uses(solid).first(&Uses::open) == 0; }

/// Solids at one location, with entities and geometry of their own, which are no instances of others'; what
/// they share they share still.
void copy_at(const TopLoc_Location& place, std::vector<TopoDS_Shape>& solids,
             const std::vector<std::size_t>& of, BRepTools_History& history) {
  std::vector<TopoDS_Shape> unplaced;
  for (const std::size_t i : of) unplaced.push_back(solids[i].Located(TopLoc_Location()));
  const TopoDS_Compound all = compound_of(unplaced);
  BRepBuilderAPI_Transform copy(all, place.Transformation(), true);
  for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape map = sub_shapes(all, type);
    for (int k = 1; k <= map.Extent(); ++k)
      history.AddModified(map(k).Moved(place), copy.ModifiedShape(map(k)));
  }
  for (const std::size_t i : of) solids[i] = copy.ModifiedShape(solids[i].Located(TopLoc_Location()));
}

/// The solids but those that stay out, as copy_at() makes them.
std::vector<TopoDS_Shape> own_copies(const std::vector<TopoDS_Shape>& solids,
                                     const std::set<std::size_t>& out, BRepTools_History& history) {
  std::vector<std::pair<TopLoc_Location, std::vector<std::size_t>>> places;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (out.count(i) != 0) continue;
    const TopLoc_Location& here = solids[i].Location();
    const auto known =
        std::find_if(places.begin(), places.end(), [&](const auto& place) { return place.first == here; });
    if (known != places.end())
      known->second.push_back(i);
    else
      places.push_back({here, {i}});
  }
  std::vector<TopoDS_Shape> own = solids;
  for (const auto& [place, of] : places) copy_at(place, own, of, history);
  return own;
}

/// The first solid that has the same faces; itself where none has.
std::vector<std::size_t> same_solids(const std::vector<TopoDS_Shape>& solids) {
  std::vector<TopTools_IndexedMapOfShape> faces;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    faces.push_back(sub_shapes(solids[i], TopAbs_FACE));
    first.push_back(i);
    for (std::size_t j = 0; j < i && first[i] == i; ++j) {
      if (faces[j].Extent() != faces[i].Extent()) continue;
      bool same = true;
      for (int k = 1; k <= faces[i].Extent() && same; ++k) same = faces[j].Contains(faces[i](k));
      if (same) first[i] = first[j];
    }
  }
  return first;
}

/// Takes the joined solids, each once, for those of the set.
void finish(const std::vector<TopoDS_Shape>& own, Joined& joined, const Handle(BRepTools_History) & copied,
            SolidSet& set) {
  const std::vector<std::size_t> first = same_solids(joined.solids());
  const Handle(BRepTools_History) changes = new BRepTools_History();
  set.solids.clear();
  for (std::size_t i = 0; i < first.size(); ++i) {
    joined.add_to(*changes, own[i]);
    add_change(*changes, own[i], joined.solids()[first[i]]);
    if (first[i] == i) set.solids.push_back(joined.solids()[i]);
  }
  copied->Merge(changes);
  set.history->Merge(copied);
}

}  // namespace

void join_common_faces(SolidSet& set) {
  std::set<std::size_t> out;
  for (std::size_t i = 0; i < set.solids.size(); ++i)
    if (!is_closed(set.solids[i])) out.insert(i);
  while (!like_faces(set.solids, out).empty()) {
    const Handle(BRepTools_History) history = new BRepTools_History();
    const std::vector<TopoDS_Shape> own = own_copies(set.solids, out, *history);
    const std::vector<LikeFaces> alike = like_faces(own, out);
    Joined joined(own, alike);
    bool all_closed = true;
    for (const LikeFaces& pair : alike)
      for (const std::size_t solid : {pair.solid, pair.kept_solid}) {
        if (is_closed(joined.solids()[solid])) continue;
        all_closed = false;
        out.insert(solid);
      }
    if (!all_closed) continue;
    finish(own, joined, history, set);
    set.notes.push_back(fmt::format("{} face(s) that two solids have alike became one each", alike.size()));
    return;
  }
}

}  // namespace octet
