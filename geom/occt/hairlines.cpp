// SPDX-License-Identifier: BSD-3-Clause
// Neighbouring sides of loops that are one line.
#include "geom/occt/hairlines.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "geom/occt/added_curve.h"
#include "geom/occt/edge_distance.h"
#include "geom/occt/face_parts.h"
#include "geom/occt/gathered.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// A side as its loop runs along it, between two vertices of the face by number; 0: it has none.
struct Side {
  TopoDS_Edge edge;
  int from = 0, to = 0;
};
using Loop = std::vector<Side>;

bool joins_the_same(const Side& a, const Side& b) {
  return a.from != 0 && a.to != 0 && a.from != a.to && a.from == b.to && a.to == b.from;
}

/// The vertices that one can go to from the first of the sides by those that they share.
std::set<int> within_reach(const Loop& sides) {
  std::set<int> reached{sides.front().from};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const Side& side : sides)
      if (reached.contains(side.from) || reached.contains(side.to)) reached.insert({side.from, side.to});
  }
  return reached;
}

bool hang_together(const Loop& sides) {
  if (sides.empty()) return false;
  const std::set<int> reached = within_reach(sides);
  return std::all_of(sides.begin(), sides.end(),
                     [&](const Side& side) { return reached.contains(side.from); });
}

/// Takes from the sides, and returns, those that do not hang together with the first.
Loop taken_apart(Loop& sides) {
  if (sides.empty()) return {};
  const std::set<int> reached = within_reach(sides);
  const auto apart = std::stable_partition(sides.begin(), sides.end(),
                                           [&](const Side& side) { return reached.contains(side.from); });
  Loop taken(apart, sides.end());
  sides.erase(apart, sides.end());
  return taken;
}

/// The loops `one` and `other`, or the one loop that both are, without their sides i and j. What came before
/// either goes on with what came behind the other.
Loop without(const Loop& one, std::size_t i, const Loop& other, std::size_t j) {
  Loop rest(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(i));
  const auto at = static_cast<std::ptrdiff_t>(j);
  if (&one == &other) {
    rest.insert(rest.end(), one.begin() + static_cast<std::ptrdiff_t>(i) + 1, one.begin() + at);
    rest.insert(rest.end(), one.begin() + at + 1, one.end());
    return rest;
  }
  rest.insert(rest.end(), other.begin() + at + 1, other.end());
  rest.insert(rest.end(), other.begin(), other.begin() + at);
  rest.insert(rest.end(), one.begin() + static_cast<std::ptrdiff_t>(i) + 1, one.end());
  return rest;
}

class Closer {
 public:
  Closer(const TopoDS_Shape& solid, double width) : solid_(solid), width_(width) {
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_);
  }

  Repair run() {
    Repair result = no_repair(solid_);
    for (TopExp_Explorer it(solid_, TopAbs_FACE); it.More(); it.Next())
      close(TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD)));
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

  [[nodiscard]] bool is_hairline(const Side& one, const Side& other) const {
    if (!joins_the_same(one, other)) return false;
    const TopoDS_Edge &a = one.edge, &b = other.edge;
    const double width = std::max({width_, BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b)});
    return !a.IsSame(b) && is_free(a) && is_free(b) &&
           std::max(edge_distance(a, b, width), edge_distance(b, a, width)) <= width;
  }

  void close(const TopoDS_Face& face) {
    const TopTools_IndexedMapOfShape vertices = sub_shapes(face, TopAbs_VERTEX);
    std::vector<TopoDS_Shape> wires;
    std::vector<Loop> loops;
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) {
      wires.push_back(it.Current());
      Loop& loop = loops.emplace_back();
      for (TopExp_Explorer edges(it.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        TopoDS_Vertex from, to;
        TopExp::Vertices(edge, from, to, true);
        loop.push_back({edge, vertices.FindIndex(from), vertices.FindIndex(to)});
      }
    }
    const std::size_t given = loops.size();
    std::vector<bool> changed(given, false);
    for (std::size_t i = 0; i < given; ++i)
      for (std::size_t j = i; j < given;) {
        Loop parted;
        const bool closed = close_between(loops[i], loops[j], face, parted);
        if (closed) changed[i] = changed[j] = true;
        if (!parted.empty()) loops.push_back(std::move(parted));
        j = closed ? i : j + 1;
      }
    if (loops.size() > given) return rebuild(face, loops);
    for (std::size_t i = 0; i < given; ++i)
      if (changed[i]) replace(wires[i], loops[i]);
  }

  /// A face for each loop that goes around one, with the holes in it.
  void rebuild(const TopoDS_Face& face, const std::vector<Loop>& loops) {
    const BRep_Builder builder;
    std::vector<TopoDS_Face> parts;
    for (const Loop& loop : loops) {
      if (loop.empty() || area_of(loop, face) <= 0.0) continue;
      parts.push_back(TopoDS::Face(face.EmptyCopied()));
      builder.Add(parts.back(), wire_of(loop));
    }
    const std::vector<TopoDS_Face> outlines = parts;
    for (const Loop& loop : loops) {
      if (loop.empty() || area_of(loop, face) > 0.0) continue;
      const gp_Pnt2d place = middle_on(loop.front().edge, face);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts.size() > 1 &&
            BRepTopAdaptor_FClass2d(outlines[k], Precision::PConfusion()).Perform(place) != TopAbs_IN)
          continue;
        builder.Add(parts[k], wire_of(loop));
        break;
      }
    }
    changes_->Replace(face, shell_of(parts));
  }

  static double area_of(const Loop& loop, const TopoDS_Face& face) {
    double area = 0.0;
    for (const Side& side : loop) area += area_along(side.edge, face);
    return area;
  }

  static TopoDS_Wire wire_of(const Loop& loop) {
    const BRep_Builder builder;
    TopoDS_Wire made;
    builder.MakeWire(made);
    for (const Side& side : loop) builder.Add(made, side.edge);
    return made;
  }

  void replace(const TopoDS_Shape& wire, const Loop& loop) {
    if (loop.empty()) {
      changes_->Remove(wire);
      return;
    }
    changes_->Replace(wire, wire_of(loop));
  }

  /// What is left of both becomes the first, but for what `parted` is given of a loop that becomes two.
  bool close_between(Loop& one, Loop& other, const TopoDS_Face& face, Loop& parted) {
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t j = &one == &other ? i + 1 : 0; j < other.size(); ++j) {
        if (!is_hairline(one[i], other[j])) continue;
        Loop rest = without(one, i, other, j);
        if (!hang_together(rest)) {
          if (&one != &other) continue;
          if (join_across_seam(one[i].edge, other[j].edge, face)) return true;
          parted = taken_apart(rest);
          if (!parts_cleanly(rest, parted, face)) {
            parted.clear();
            continue;
          }
        }
        // The better one stays.
        if (BRep_Tool::Tolerance(other[j].edge) < BRep_Tool::Tolerance(one[i].edge))
          join(other[j].edge, one[i].edge);
        else
          join(one[i].edge, other[j].edge);
        if (&one != &other) other.clear();
        one = std::move(rest);
        return true;
      }
    return false;
  }

  /// Whether two loops come of one: a neck without width, or a crack from the outline to a hole.
  static bool parts_cleanly(const Loop& one, const Loop& other, const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face, false);
    return !surface.IsUPeriodic() && !surface.IsVPeriodic() && hang_together(one) && hang_together(other) &&
           (area_of(one, face) > 0.0 || area_of(other, face) > 0.0);
  }

  /// Where the two are a period apart the face is on either side of the line: they are a piece of its seam,
  /// to which other faces come. True where it became one edge.
  bool join_across_seam(const TopoDS_Edge& kept, const TopoDS_Edge& gone, const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face, false);
    const gp_Vec2d shift(middle_on(kept, face), middle_on(gone, face));
    gp_Vec2d turn(0.0, 0.0);
    if (surface.IsUPeriodic() && std::abs(shift.X()) > 0.5 * surface.UPeriod())
      turn.SetX(std::copysign(surface.UPeriod(), shift.X()));
    if (surface.IsVPeriodic() && std::abs(shift.Y()) > 0.5 * surface.VPeriod())
      turn.SetY(std::copysign(surface.VPeriod(), shift.Y()));
    if (turn.SquareMagnitude() == 0.0) return false;
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) own = BRep_Tool::CurveOnSurface(kept, face, first, last);
    const auto across = Handle(Geom2d_Curve)::DownCast(own->Translated(turn));
    const bool forward = kept.Orientation() == TopAbs_FORWARD;
    join(kept, gone);
    BRep_Builder().UpdateEdge(kept, forward ? own : across, forward ? across : own, face,
                              BRep_Tool::Tolerance(kept));
    return true;
  }

  static gp_Pnt2d middle_on(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0, last = 0.0;
    return BRep_Tool::CurveOnSurface(edge, face, first, last)->Value(0.5 * (first + last));
  }

  void join(const TopoDS_Edge& kept, const TopoDS_Edge& gone) {
    touched_.Add(kept);
    touched_.Add(gone);
    BRep_Builder().UpdateEdge(kept, edge_distance(gone, kept, std::numeric_limits<double>::infinity()));
    // The face beyond the edge that goes is bounded by the other one now.
    for (const TopoDS_Shape& face : faces_of_.FindFromKey(gone)) add_curve(kept, TopoDS::Face(face));
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
