// SPDX-License-Identifier: BSD-3-Clause
// Crossings in (u,v), a vertex at each, and there loops turn aside instead of going on.
#include "geom/occt/crossed_loops.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <vector>

#include "geom/occt/edge_cuts.h"
#include "geom/occt/face_parts.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// A side of a face that is no seam, as it runs in (u,v).
struct TrimmedSide {
  TopoDS_Edge edge;
  Handle(Geom2d_TrimmedCurve) curve;
  Bnd_Box2d box;
};

std::vector<TrimmedSide> sides_of(const TopoDS_Face& face) {
  std::vector<TrimmedSide> sides;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull() || BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
    TrimmedSide side{edge, new Geom2d_TrimmedCurve(curve, first, last), {}};
    BndLib_Add2dCurve::Add(side.curve, 0.0, side.box);
    sides.push_back(side);
  }
  return sides;
}

/// Whether the parameter is clear of the edge's ends, in space.
bool is_inside(const TopoDS_Edge& edge, double t) {
  constexpr double kClearOfEnds = 10.0;
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull()) return false;
  for (const double end : {first, last})
    if (curve->Value(t).Distance(curve->Value(end)) <= kClearOfEnds * BRep_Tool::Tolerance(edge))
      return false;
  return true;
}

class LoopSearch {
 public:
  explicit LoopSearch(const TopoDS_Shape& solid) : edges_(sub_shapes(solid, TopAbs_EDGE)) {
    const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
    for (int i = 1; i <= faces.Extent(); ++i) {
      const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
      const std::vector<TrimmedSide> sides = sides_of(face);
      for (std::size_t a = 0; a < sides.size(); ++a)
        for (std::size_t b = a + 1; b < sides.size(); ++b)
          if (!sides[a].box.IsOut(sides[b].box)) look_at(face, sides[a], sides[b]);
    }
  }

  [[nodiscard]] Repair cut(const TopoDS_Shape& solid) const { return cuts_.apply(solid, edges_); }
  [[nodiscard]] const TopTools_IndexedMapOfShape& faces() const { return faces_; }
  [[nodiscard]] const TopTools_IndexedMapOfShape& vertices() const { return vertices_; }

 private:
  void look_at(const TopoDS_Face& face, const TrimmedSide& a, const TrimmedSide& b) {
    const Geom2dAPI_InterCurveCurve crossings(a.curve, b.curve, Precision::PConfusion());
    for (int i = 1; i <= crossings.NbPoints(); ++i) {
      const IntRes2d_IntersectionPoint& point = crossings.Intersector().Point(i);
      const double s = point.ParamOnFirst(), t = point.ParamOnSecond();
      const bool crosses = point.TransitionOfFirst().TransitionType() == IntRes2d_In ||
                           point.TransitionOfFirst().TransitionType() == IntRes2d_Out;
      if (crosses && is_inside(a.edge, s) && is_inside(b.edge, t)) add(face, a.edge, s, b.edge, t);
    }
  }

  void add(const TopoDS_Face& face, const TopoDS_Edge& a, double s, const TopoDS_Edge& b, double t) {
    double first = 0.0, last = 0.0;
    const gp_Pnt p = BRep_Tool::Curve(a, first, last)->Value(s),
                 q = BRep_Tool::Curve(b, first, last)->Value(t);
    const gp_Pnt middle(0.5 * (p.XYZ() + q.XYZ()));
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, middle, Precision::Confusion());
    const double distance = std::max(Precision::Confusion(), 0.5 * p.Distance(q));
    cuts_.add(edges_.FindIndex(a), {s, distance, vertex});
    cuts_.add(edges_.FindIndex(b), {t, distance, vertex});
    vertices_.Add(vertex);
    faces_.Add(face);
  }

  TopTools_IndexedMapOfShape edges_, faces_, vertices_;
  EdgeCuts cuts_;
};

/// A part of a loop that does not cross itself.
struct Lobe {
  std::vector<TopoDS_Edge> edges;
  double area = 0.0;  ///< in (u,v), negative where it runs the wrong way
};

bool same_curve(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  double first = 0.0, last = 0.0;
  return BRep_Tool::Curve(a, first, last) == BRep_Tool::Curve(b, first, last);
}

/// What follows an edge around its lobe: at a crossing not the other piece of the same side. Its own number
/// where that is not clear.
std::size_t next_of(std::size_t edge, const std::vector<TopoDS_Edge>& edges,
                    const TopTools_IndexedMapOfShape& vertices) {
  const TopoDS_Vertex end = TopExp::LastVertex(edges[edge], true);
  const bool crossing = vertices.Contains(end);
  std::size_t next = edge;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == edge || !TopExp::FirstVertex(edges[i], true).IsSame(end)) continue;
    if (crossing && same_curve(edges[i], edges[edge])) continue;
    if (next != edge) return edge;
    next = i;
  }
  return next;
}

/// Empty where the edges of the wire do not clearly follow one another.
std::vector<Lobe> lobes_of(const TopoDS_Shape& wire, const TopoDS_Face& face,
                           const TopTools_IndexedMapOfShape& vertices) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next())
    edges.push_back(TopoDS::Edge(it.Current()));
  std::vector<bool> used(edges.size(), false);
  std::vector<Lobe> lobes;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    Lobe lobe;
    std::size_t at = first;
    do {
      used[at] = true;
      lobe.edges.push_back(edges[at]);
      lobe.area += area_along(edges[at], face);
      at = next_of(at, edges, vertices);
    } while (!used[at]);
    if (at != first || lobe.edges.size() < 2) return {};
    lobes.push_back(lobe);
  }
  return lobes;
}

bool has_any(const TopoDS_Shape& wire, const TopTools_IndexedMapOfShape& vertices) {
  for (TopExp_Explorer it(wire, TopAbs_VERTEX); it.More(); it.Next())
    if (vertices.Contains(it.Current())) return true;
  return false;
}

/// The wire of a lobe, run the right way around, in a face that is turned if the lobe is not.
TopoDS_Face face_of(const Lobe& lobe, const TopoDS_Face& whole) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const bool turned = lobe.area < 0.0;
  for (const TopoDS_Edge& edge : lobe.edges) builder.Add(wire, turned ? edge.Reversed() : TopoDS_Shape(edge));
  wire.Closed(true);
  TopoDS_Face face = TopoDS::Face(whole.EmptyCopied());
  builder.NaturalRestriction(face, false);
  builder.Add(face, wire);
  if (turned) face.Reverse();
  return face;
}

/// The parts of the forward face; fewer than two where it cannot be parted.
std::vector<TopoDS_Face> parts_of(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& vertices) {
  std::vector<TopoDS_Face> parts;
  std::vector<TopoDS_Shape> others;
  int upright = 0;
  for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) {
    if (!has_any(it.Current(), vertices)) {
      others.push_back(it.Current());
      continue;
    }
    const std::vector<Lobe> lobes = lobes_of(it.Current(), face, vertices);
    if (lobes.size() < 2 || !parts.empty()) return {};
    for (const Lobe& lobe : lobes) {
      upright += lobe.area > 0.0 ? 1 : 0;
      parts.push_back(face_of(lobe, face));
    }
  }
  if (!others.empty() && upright != 1) return {};
  for (TopoDS_Face& part : parts)
    if (part.Orientation() == TopAbs_FORWARD)
      for (const TopoDS_Shape& wire : others) BRep_Builder().Add(part, wire);
  return parts;
}

}  // namespace

Repair split_crossed_loops(const TopoDS_Shape& solid) {
  const LoopSearch search(solid);
  if (search.faces().IsEmpty()) return no_repair(solid);
  FaceParts parts(solid, search.cut(solid));
  for (int i = 1; i <= search.faces().Extent(); ++i)
    parts.part(TopoDS::Face(search.faces()(i)),
               [&](const TopoDS_Face& face) { return parts_of(face, search.vertices()); });
  return parts.apply();
}

}  // namespace octet
