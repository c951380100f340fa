// SPDX-License-Identifier: BSD-3-Clause
// A walk along one side, with the foot on the other.
#include "geom/occt/crossed_sides.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/occt/edge_cuts.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Sides that part at a larger angle (cosine; five degrees) do not run side by side.
constexpr double kSideBySide = 0.9962;
/// Crossings nearer to an end of a side than so many tolerances belong to the end.
constexpr double kSidesClearOfEnds = 10.0;
/// A side that is no farther beyond the other is there by rounding (mm).
constexpr double kRounding = 1e-6;
/// The walk: from this share of the side, growing by this factor a step.
constexpr double kFirstStep = 1e-4, kStepGrowth = 1.1;

/// A side of the face's loop, seen from one of its ends.
struct CrossedSide {
  CrossedSide(const TopoDS_Edge& its_edge, const TopoDS_Vertex& from) : edge(its_edge), curve(its_edge) {
    const bool first = TopExp::FirstVertex(edge).IsSame(from);
    begin = first ? curve.FirstParameter() : curve.LastParameter();
    length = first ? curve.LastParameter() - begin : curve.FirstParameter() - begin;
  }
  [[nodiscard]] double parameter(double share) const { return begin + share * length; }
  [[nodiscard]] gp_Pnt at(double share) const { return curve.Value(parameter(share)); }
  /// Away from the end; zero where the curve has no tangent.
  [[nodiscard]] gp_Vec tangent() const {
    gp_Pnt point;
    gp_Vec along;
    curve.D1(begin, point, along);
    return length < 0.0 ? along.Reversed() : along;
  }

  TopoDS_Edge edge;  ///< as it is oriented in the face
  BRepAdaptor_Curve curve;
  double begin = 0.0, length = 0.0;  ///< parameters
};

/// How one side lies to another at one place.
struct Lie {
  double distance = 0.0;  ///< to the other side
  double inside = 0.0;    ///< how far inside the face it is, seen from the other side
  double foot = 0.0;      ///< parameter of the other
};

class SideCorner {
 public:
  SideCorner(const TopoDS_Face& face, const TopoDS_Edge& a, const TopoDS_Edge& b, const TopoDS_Vertex& at)
      : surface_(face, false), a_(a, at), b_(b, at) {
    pcurve_ = BRep_Tool::CurveOnSurface(b, face, first_, last_);
    tolerance_ = std::max(BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b));
  }

  /// Where the two cross, as cuts of the one and the other that share a new vertex.
  [[nodiscard]] std::optional<std::pair<Cut, Cut>> crossing() const {
    if (pcurve_.IsNull() || !side_by_side()) return {};
    const std::optional<double> share = last_crossing();
    if (!share) return {};
    const std::optional<Lie> lie = lie_at(*share);
    if (!lie) return {};
    const gp_Pnt on_a = a_.at(*share), on_b = b_.curve.Value(lie->foot);
    for (const gp_Pnt& end : {a_.at(0.0), a_.at(1.0), b_.at(1.0)})
      if (on_a.Distance(end) <= kSidesClearOfEnds * tolerance_) return {};
    const gp_Pnt middle(0.5 * (on_a.XYZ() + on_b.XYZ()));
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, middle, Precision::Confusion());
    const double off = middle.Distance(on_a);
    return std::pair(Cut{a_.parameter(*share), off, vertex}, Cut{lie->foot, off, vertex});
  }

 private:
  [[nodiscard]] bool side_by_side() const {
    const gp_Vec a = a_.tangent(), b = b_.tangent();
    return a.Dot(b) > kSideBySide * a.Magnitude() * b.Magnitude();
  }

  [[nodiscard]] std::optional<Lie> lie_at(double share) const {
    const gp_Pnt point = a_.at(share);
    const Extrema_ExtPC feet(point, b_.curve);
    if (!feet.IsDone()) return {};
    int nearest = 0;
    for (int i = 1; i <= feet.NbExt(); ++i)
      if (feet.IsMin(i) && (nearest == 0 || feet.SquareDistance(i) < feet.SquareDistance(nearest)))
        nearest = i;
    if (nearest == 0) return {};
    const double foot = feet.Point(nearest).Parameter();
    gp_Pnt on_b, on_face;
    gp_Vec along, du, dv;
    b_.curve.D1(foot, on_b, along);
    const gp_Pnt2d uv = pcurve_->Value(foot);
    surface_.D1(uv.X(), uv.Y(), on_face, du, dv);
    // The face lies to the left of its sides.
    gp_Vec inwards =
        du.Crossed(dv).Crossed(b_.edge.Orientation() == TopAbs_REVERSED ? along.Reversed() : along);
    if (inwards.Magnitude() == 0.0) return {};
    return Lie{std::sqrt(feet.SquareDistance(nearest)), gp_Vec(on_b, point).Dot(inwards.Normalized()), foot};
  }

  /// Of the places nearer than the tolerance, the last before which the side is on the other side of the
  /// other than where the two part; none where they never do, or always were.
  [[nodiscard]] std::optional<double> last_crossing() const {
    std::vector<std::pair<double, double>> walk;  // share, inside
    double parted = 0.0;
    for (double share = kFirstStep; share < 1.0 && parted == 0.0; share *= kStepGrowth) {
      const std::optional<Lie> lie = lie_at(share);
      if (!lie) return {};
      walk.emplace_back(share, lie->inside);
      if (lie->distance > tolerance_) parted = lie->inside;
    }
    if (parted == 0.0) return {};
    const auto is_wrong = [&](double inside) { return inside * parted < 0.0; };
    for (std::size_t i = walk.size(); i-- > 1;) {
      if (!is_wrong(walk[i - 1].second) || std::abs(walk[i - 1].second) <= kRounding) continue;
      double wrong = walk[i - 1].first, right = walk[i].first;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (wrong + right);
        const std::optional<Lie> lie = lie_at(middle);
        if (!lie) return {};
        (is_wrong(lie->inside) ? wrong : right) = middle;
      }
      return right;
    }
    return {};
  }

  BRepAdaptor_Surface surface_;
  CrossedSide a_, b_;
  Handle(Geom2d_Curve) pcurve_;
  double first_ = 0.0, last_ = 0.0, tolerance_ = 0.0;
};

/// Whether a side may be split for how it lies to others.
bool is_plain(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  return !TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge)) && !BRep_Tool::Degenerated(edge) &&
         !BRep_Tool::IsClosed(edge, face);
}

}  // namespace

Repair split_crossed_sides(const TopoDS_Shape& solid) {
  const TopTools_IndexedMapOfShape edges = sub_shapes(solid, TopAbs_EDGE);
  EdgeCuts cuts;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
      TopTools_IndexedDataMapOfShapeListOfShape sides_at;
      TopExp::MapShapesAndAncestors(wires.Current(), TopAbs_VERTEX, TopAbs_EDGE, sides_at);
      for (int v = 1; v <= sides_at.Extent(); ++v) {
        if (sides_at(v).Extent() != 2) continue;
        const TopoDS_Edge a = TopoDS::Edge(sides_at(v).First()), b = TopoDS::Edge(sides_at(v).Last());
        if (!is_plain(face, a) || !is_plain(face, b)) continue;
        try {
          const auto crossing = SideCorner(face, a, b, TopoDS::Vertex(sides_at.FindKey(v))).crossing();
          if (!crossing) continue;
          cuts.add(edges.FindIndex(a), crossing->first);
          cuts.add(edges.FindIndex(b), crossing->second);
        } catch (const Standard_Failure&) {  // OCCT cannot tell: they stay
        }
      }
    }
  }
  return cuts.apply(solid, edges);
}

}  // namespace octet
