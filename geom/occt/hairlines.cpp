// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring sides of loops that are one line.
#include "geom/occt/hairlines.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <limits>

#include "geom/occt/edge_distance.h"

namespace octet {
namespace {

bool joins_the_same(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  TopoDS_Vertex a0, a1, b0, b1;
  TopExp::Vertices(a, a0, a1, true);
  TopExp::Vertices(b, b0, b1, true);
  return !a0.IsNull() && !a1.IsNull() && !a0.IsSame(a1) && a0.IsSame(b1) && a1.IsSame(b0);
}

class Closer {
 public:
  Closer(const TopoDS_Shape& solid, double width) : solid_(solid), width_(width) {
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_);
  }

  Repair run() {
    Repair result = no_repair(solid_);
    for (TopExp_Explorer it(solid_, TopAbs_FACE); it.More(); it.Next()) {
      const TopoDS_Face face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
      for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next())
        close(TopoDS::Wire(wires.Current()));
    }
    if (gone_.empty()) return result;
    result.solid = changes_->Apply(solid_);
    result.history = changes_->History();
    result.entities = gone_;
    return result;
  }

 private:
  /// Has two faces, and has not been given to another yet.
  [[nodiscard]] bool is_free(const TopoDS_Edge& edge) const {
    return !BRep_Tool::Degenerated(edge) && !touched_.Contains(edge) &&
           faces_of_.FindFromKey(edge).Extent() == 2 &&
           !faces_of_.FindFromKey(edge).First().IsSame(faces_of_.FindFromKey(edge).Last());
  }

  [[nodiscard]] bool is_hairline(const TopoDS_Edge& a, const TopoDS_Edge& b) const {
    const double width = std::max({width_, BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b)});
    return !a.IsSame(b) && is_free(a) && is_free(b) && joins_the_same(a, b) &&
           std::max(edge_distance(a, b, width), edge_distance(b, a, width)) <= width;
  }

  void close(const TopoDS_Wire& wire) {
    std::vector<TopoDS_Edge> loop;
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next())
      loop.push_back(TopoDS::Edge(it.Current()));
    bool any = false;
    while (close_one(loop)) any = true;
    if (!any) return;
    const BRep_Builder builder;
    TopoDS_Wire made;
    builder.MakeWire(made);
    for (const TopoDS_Edge& edge : loop) builder.Add(made, edge);
    changes_->Replace(wire, made.Oriented(wire.Orientation()));
  }

  bool close_one(std::vector<TopoDS_Edge>& loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() > 2; ++i)
      for (std::size_t j = i + 1; j < loop.size(); ++j) {
        if (!is_hairline(loop[i], loop[j]) || !has_tip(loop, loop[i])) continue;
        // The better one stays.
        if (BRep_Tool::Tolerance(loop[j]) < BRep_Tool::Tolerance(loop[i])) std::swap(loop[i], loop[j]);
        join(loop[i], loop[j]);
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(j));
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    return false;
  }

  /// Whether no more than two sides of the loop meet at one end of the edge.
  static bool has_tip(const std::vector<TopoDS_Edge>& loop, const TopoDS_Edge& edge) {
    for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
      const auto ends_there = [&](const TopoDS_Edge& side) {
        return end.IsSame(TopExp::FirstVertex(side)) || end.IsSame(TopExp::LastVertex(side));
      };
      if (std::count_if(loop.begin(), loop.end(), ends_there) == 2) return true;
    }
    return false;
  }

  void join(const TopoDS_Edge& kept, const TopoDS_Edge& gone) {
    touched_.Add(kept);
    touched_.Add(gone);
    BRep_Builder().UpdateEdge(kept, edge_distance(gone, kept, std::numeric_limits<double>::infinity()));
    // In the loop the two run against each other.
    changes_->Replace(gone, kept.Reversed());
    gone_.push_back(gone);
  }

  const TopoDS_Shape& solid_;
  double width_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_;
  Handle(ShapeBuild_ReShape) changes_ = new ShapeBuild_ReShape;
  TopTools_MapOfShape touched_;
  std::vector<TopoDS_Shape> gone_;
};

}  // namespace

Repair close_hairlines(const TopoDS_Shape& solid, double width) { return Closer(solid, width).run(); }

}  // namespace octet
