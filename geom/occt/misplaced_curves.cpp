// SPDX-License-Identifier: BSD-3-Clause
// The gap is sampled; the new curve is OCCT's projection of the edge, joined to its neighbours over periods.
#include "geom/occt/misplaced_curves.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Vec2d.hxx>
#include <limits>
#include <utility>

#include "geom/occt/curve_gaps.h"
#include "geom/occt/shape_box.h"

namespace octet {
namespace {

constexpr double kMisplaced = 0.1;  // of the edge's length
constexpr double kBetter = 0.1;     // of the gap

bool misplaced(const TopoDS_Edge& edge, double gap) {
  if (gap <= Precision::Confusion()) return false;
  const BRepAdaptor_Curve curve(edge);
  return gap > kMisplaced * GCPnts_AbscissaPoint::Length(curve, 0.01 * gap);
}

/// True when the new curve is better; else the old one is there again.
bool renew(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap) {
  double s0 = 0.0, s1 = 0.0;
  const auto old = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
  const BRep_Builder builder;
  builder.UpdateEdge(edge, Handle(Geom2d_Curve)(), face, Precision::Confusion());
  ShapeFix_Edge fix;
  fix.FixAddPCurve(edge, face, false, Precision::Confusion());
  double t0 = 0.0, t1 = 0.0;
  if (!BRep_Tool::CurveOnSurface(edge, face, t0, t1).IsNull() && curve_gap(edge, face) < kBetter * gap)
    return true;
  builder.UpdateEdge(edge, old, face, Precision::Confusion());
  builder.Range(edge, face, s0, s1);
  return false;
}

/// Ends of an edge's curve on a face, in the edge's direction.
std::pair<gp_Pnt2d, gp_Pnt2d> ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double s0 = 0.0, s1 = 0.0;
  const auto curve = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
  if (edge.Orientation() == TopAbs_REVERSED) std::swap(s0, s1);
  return {curve->Value(s0), curve->Value(s1)};
}

/// Moves the curve of a half edge; of a seam the one of its side.
void move_curve(const TopoDS_Edge& edge, const TopoDS_Face& face, const gp_Vec2d& shift) {
  const auto moved = [&](const TopoDS_Edge& half) {
    double s0 = 0.0, s1 = 0.0;
    const auto curve = BRep_Tool::CurveOnSurface(half, face, s0, s1);
    return half.IsEqual(edge) ? Handle(Geom2d_Curve)::DownCast(curve->Translated(shift)) : curve;
  };
  double s0 = 0.0, s1 = 0.0;
  BRep_Tool::Range(edge, face, s0, s1);
  const BRep_Builder builder;
  const double tolerance = Precision::Confusion();
  if (BRep_Tool::IsClosed(edge, face))
    builder.UpdateEdge(edge, moved(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD))),
                       moved(TopoDS::Edge(edge.Oriented(TopAbs_REVERSED))), face, tolerance);
  else
    builder.UpdateEdge(edge, moved(edge), face, tolerance);
  builder.Range(edge, face, s0, s1);
}

/// Takes edges out of a loop that pass for poles, but whose curve on the face runs where there is none: they
/// were to bridge what lies whole periods apart. OCCT's reader may give their vertices a tolerance that holds
/// all of such a curve, so that of the face's size no more than a share is left to it.
bool drop_false_poles(TopoDS_Wire wire, const TopoDS_Face& face) {
  constexpr double kShare = 0.01;
  constexpr double kRounding = 1e-6;  // of the face's size: a profile in ten digits misses its axis by that
  const auto surface = BRep_Tool::Surface(face);
  std::vector<TopoDS_Edge> poles;
  for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
    double s0 = 0.0, s1 = 0.0;
    const auto curve = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
    if (!BRep_Tool::Degenerated(edge) || curve.IsNull()) continue;
    const auto at = [&](double share) {
      const gp_Pnt2d uv = curve->Value(s0 + share * (s1 - s0));
      return surface->Value(uv.X(), uv.Y());
    };
    const gp_Pnt end = at(0.0);
    double away = 0.0;
    for (const double share : {0.1, 0.3, 0.6}) away = std::max(away, end.Distance(at(share)));
    if (end.Distance(at(1.0)) > Precision::Confusion() || away <= 10.0 * Precision::Confusion()) continue;
    const double size = diagonal_of(bare_box_of(face));
    const double allowed = std::min(BRep_Tool::Tolerance(TopExp::FirstVertex(edge)), kShare * size);
    if (away > std::max(allowed, kRounding * size)) poles.push_back(edge);
  }
  wire.Free(true);
  const BRep_Builder builder;
  for (const TopoDS_Edge& edge : poles) builder.Remove(wire, edge);
  return !poles.empty();
}

/// Moves curves of a loop by whole periods to where those before them end. False when all were there.
class PeriodsJoined {
 public:
  explicit PeriodsJoined(const TopoDS_Face& face) : face_(face) {
    const auto surface = BRep_Tool::Surface(face);
    if (surface->IsUPeriodic()) period_[0] = surface->UPeriod();
    if (surface->IsVPeriodic()) period_[1] = surface->VPeriod();
  }
  [[nodiscard]] bool join(const TopoDS_Wire& wire) {
    if (period_[0] == 0.0 && period_[1] == 0.0) return false;
    std::vector<TopoDS_Edge> left;
    double s0 = 0.0, s1 = 0.0;
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
      const bool side = edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
      if (!side || BRep_Tool::CurveOnSurface(edge, face_, s0, s1).IsNull()) return false;
      left.push_back(edge);
    }
    bool any = false;
    std::size_t next = 0;
    while (!left.empty()) {
      const TopoDS_Edge at = left[next];
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
      const gp_Pnt2d end = ends(at, face_).second;
      // A seam does not turn back on itself where another follows, be the gap at the vertex ever so wide.
      std::pair nearest(true, std::numeric_limits<double>::infinity());
      next = 0;
      gp_Vec2d shift(0.0, 0.0);
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (!TopExp::FirstVertex(left[i], true).IsSame(TopExp::LastVertex(at, true))) continue;
        const gp_Vec2d step(ends(left[i], face_).first, end);
        const gp_Vec2d periods(whole(step.X(), period_[0]), whole(step.Y(), period_[1]));
        // Of those that begin here but for whole periods, the one that is moved least.
        constexpr double kMoved = 1e-4;
        const std::pair rest(static_cast<bool>(left[i].IsSame(at)),
                             (step - periods).Magnitude() + kMoved * periods.Magnitude());
        if (rest >= nearest) continue;
        nearest = rest;
        next = i;
        shift = periods;
      }
      if (shift.Magnitude() == 0.0) continue;
      move_curve(left[next], face_, shift);
      any = true;
    }
    return any;
  }

 private:
  static double whole(double shift, double period) {
    return period > 0.0 ? period * std::round(shift / period) : 0.0;
  }

  TopoDS_Face face_;
  std::array<double, 2> period_{};
};

}  // namespace

CurvesRenewed renew_misplaced_curves(const TopoDS_Shape& solid) {
  CurvesRenewed result;
  TopTools_MapOfShape seen;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (!seen.Add(face)) continue;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
      const double gap = curve_gap(edge, face);
      if (misplaced(edge, gap) && renew(edge, face, gap)) result.curves.push_back({edge, face, gap});
    }
    bool joined = false;
    PeriodsJoined periods(face);
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next())
      joined = drop_false_poles(TopoDS::Wire(it.Current()), face) || joined;
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next())
      joined = periods.join(TopoDS::Wire(it.Current())) || joined;
    if (joined) result.joined.push_back(face);
  }
  std::vector<TopoDS_Edge> edges;
  for (const CurveRenewed& one : result.curves) edges.push_back(one.edge);
  if (!edges.empty()) lower_tolerances(solid, edges);
  return result;
}

}  // namespace octet
