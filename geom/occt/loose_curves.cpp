// SPDX-License-Identifier: BSD-3-Clause
// Nearest points of the surface along an edge, from where the old curve is, and a spline through them.
#include "geom/occt/loose_curves.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/occt/canonical.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

/// A new curve must leave no more than this share of the gap.
constexpr double kBetter = 0.2;
/// More pieces win nothing where the curve is off by hardly more than the edge itself is off the face.
constexpr double kAsOff = 1.05;
constexpr int kFewest = 8, kMost = 256;

/// The ranges that surface parameters stay within; of a periodic one there is none.
struct Bounds {
  std::array<double, 2> low{}, high{};
};

Bounds bounds_of(const Geom_Surface& surface) {
  Bounds bounds;
  surface.Bounds(bounds.low[0], bounds.high[0], bounds.low[1], bounds.high[1]);
  const std::array<bool, 2> periodic{surface.IsUPeriodic(), surface.IsVPeriodic()};
  for (std::size_t i = 0; i < 2; ++i)
    if (periodic[i]) {
      bounds.low[i] = -Precision::Infinite();
      bounds.high[i] = Precision::Infinite();
    }
  return bounds;
}

/// Newton's method for the foot of a point on a surface, from `uv`. At a pole the parameter that moves
/// nothing stays.
Vec2 foot_from(const Geom_Surface& surface, const Bounds& bounds, const Vec3& point, Vec2 uv) {
  constexpr int kMostSteps = 20;
  constexpr double kFlat = 1e-12, kStill = 1e-14;
  for (int step = 0; step < kMostSteps; ++step) {
    gp_Pnt at;
    gp_Vec du, dv, duu, dvv, duv;
    surface.D2(uv[0], uv[1], at, du, dv, duu, dvv, duv);
    const Vec3 off = to_vec(at) - point;
    const Vec3 u = to_vec(du), v = to_vec(dv);
    const Vec2 slope(off.dot(u), off.dot(v));
    double a = u.squaredNorm() + off.dot(to_vec(duu)), c = v.squaredNorm() + off.dot(to_vec(dvv));
    double b = u.dot(v) + off.dot(to_vec(duv));
    // Where the distance bends the wrong way the tangent plane leads down.
    if (!(a > 0.0 && c > 0.0 && a * c - b * b > kFlat * a * c)) {
      a = u.squaredNorm();
      b = u.dot(v);
      c = v.squaredNorm();
    }
    const double det = a * c - b * b;
    Vec2 move = Vec2::Zero();
    if (det > kFlat * std::max(a, c) * std::max(a, c))
      move = Vec2(b * slope[1] - c * slope[0], b * slope[0] - a * slope[1]) / det;
    else if (a > c)
      move[0] = -slope[0] / a;
    else if (c > 0.0)
      move[1] = -slope[1] / c;
    const Vec2 before = uv;
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(i);
      uv[i] = std::clamp(uv[i] + move[i], bounds.low[k], bounds.high[k]);
    }
    if ((uv - before).norm() <= kStill * (1.0 + uv.norm())) break;
  }
  return uv;
}

class Fit {
 public:
  Fit(const TopoDS_Edge& edge, const TopoDS_Face& face)
      : in_space_(BRep_Tool::Curve(edge, t0_, t1_)),
        on_face_(BRep_Tool::CurveOnSurface(edge, face, s0_, s1_)),
        surface_(BRep_Tool::Surface(face)) {
    if (!surface_.IsNull()) bounds_ = bounds_of(*surface_);
  }
  [[nodiscard]] bool possible() const {
    return !in_space_.IsNull() && !on_face_.IsNull() && !surface_.IsNull() && t1_ > t0_;
  }

  /// The curve with the fewest pieces that is no more than `near` off, or as near as the edge allows; none
  /// where none is nearer than a share of `gap`.
  [[nodiscard]] Handle(Geom2d_Curve) best(double gap, double near) const {
    Handle(Geom2d_Curve) best;
    double least = kBetter * gap;
    for (int pieces = kFewest; pieces <= kMost; pieces *= 2) {
      double edge_off = 0.0;
      const Handle(Geom2d_Curve) curve = through(pieces, kBetter * gap, edge_off);
      if (curve.IsNull() || edge_off > kBetter * gap) break;
      const double off = std::max(edge_off, gap_between(*curve, pieces));
      if (off < least) {
        least = off;
        best = curve;
      }
      if (off <= std::max(kAsOff * edge_off, near)) break;
    }
    return best;
  }

  [[nodiscard]] double first() const { return t0_; }
  [[nodiscard]] double last() const { return t1_; }

 private:
  [[nodiscard]] double at(double share) const { return t0_ + share * (t1_ - t0_); }

  /// `edge_off`: how far the edge is from the surface at the points, of which `enough` is near.
  [[nodiscard]] Handle(Geom2d_Curve) through(int pieces, double enough, double& edge_off) const {
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, pieces + 1);
    const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, pieces + 1);
    Vec2 last = Vec2::Zero();
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      const gp_Pnt2d seed = on_face_->Value(s0_ + share * (s1_ - s0_));
      const gp_Pnt point = in_space_->Value(at(share));
      const auto off = [&](const Vec2& uv) { return surface_->Value(uv[0], uv[1]).Distance(point); };
      Vec2 uv = foot_from(*surface_, bounds_, to_vec(point), Vec2(seed.X(), seed.Y()));
      // Where the old curve is far off its nearest point may be another: that beside the last one is tried.
      if (i > 0 && off(uv) > enough) {
        const Vec2 next = foot_from(*surface_, bounds_, to_vec(point), last);
        if (off(next) < off(uv)) uv = next;
      }
      last = uv;
      edge_off = std::max(edge_off, off(uv));
      points->SetValue(i + 1, gp_Pnt2d(uv[0], uv[1]));
      parameters->SetValue(i + 1, at(share));
    }
    try {
      Geom2dAPI_Interpolate fit(points, parameters, false, Precision::PConfusion());
      fit.Perform();
      if (fit.IsDone()) return Handle(Geom2d_Curve)(fit.Curve());
    } catch (const Standard_Failure&) {
      // Points that coincide in (u,v): no curve through them.
    }
    return {};
  }

  /// Largest distance at equal parameter, between the points that the curve was made through.
  [[nodiscard]] double gap_between(const Geom2d_Curve& curve, int pieces) const {
    constexpr int kBetween = 4;
    double gap = 0.0;
    for (int i = 0; i < kBetween * pieces; ++i) {
      if (i % kBetween == 0) continue;
      const double t = at(static_cast<double>(i) / (kBetween * pieces));
      const gp_Pnt2d uv = curve.Value(t);
      gap = std::max(gap, surface_->Value(uv.X(), uv.Y()).Distance(in_space_->Value(t)));
    }
    return gap;
  }

  double t0_ = 0.0, t1_ = 0.0, s0_ = 0.0, s1_ = 0.0;
  Handle(Geom_Curve) in_space_;
  Handle(Geom2d_Curve) on_face_;
  Handle(Geom_Surface) surface_;
  Bounds bounds_;
};

bool can_be_fitted(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  return !BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face);
}

bool fit_within(double near, const TopoDS_Edge& edge, const TopoDS_Face& face, double gap) {
  const Fit fit(edge, face);
  if (!fit.possible()) return false;
  const Handle(Geom2d_Curve) curve = fit.best(gap, near);
  if (curve.IsNull()) return false;
  const BRep_Builder builder;
  builder.UpdateEdge(edge, curve, face, Precision::Confusion());
  builder.Range(edge, face, fit.first(), fit.last());
  return true;
}

/// The edges whose curves on the face are off by more than `apart`.
std::vector<CurveRenewed> loose_curves(const TopoDS_Face& face, double apart) {
  std::vector<CurveRenewed> loose;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!can_be_fitted(edge, face)) continue;
    if (const double gap = curve_gap(edge, face); gap > apart) loose.push_back({edge, face, gap});
  }
  return loose;
}

/// Whether the face is no wider than what its curves are off: whatever its surface is, it is an edge to the
/// faces beside it, and the tolerance of its sides says so.
bool is_strip(const TopoDS_Face& face, const std::vector<CurveRenewed>& loose) {
  constexpr double kOfWidth = 0.25;
  double widest = 0.0;
  for (const CurveRenewed& one : loose) widest = std::max(widest, one.gap);
  return widest > kOfWidth * width_of(face);
}

}  // namespace

bool fit_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  if (!can_be_fitted(edge, forward)) return false;
  const double gap = curve_gap(edge, forward);
  return gap > Precision::Confusion() && fit_within(Precision::Confusion(), edge, forward, gap);
}

std::vector<CurveRenewed> fit_loose_curves(const TopoDS_Shape& solid, double apart) {
  std::vector<CurveRenewed> fitted;
  TopTools_MapOfShape seen;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    if (!seen.Add(face)) continue;
    const std::vector<CurveRenewed> loose = loose_curves(face, apart);
    if (loose.empty() || is_strip(face, loose)) continue;
    for (const CurveRenewed& one : loose)
      if (fit_within(apart, one.edge, face, one.gap)) fitted.push_back(one);
  }
  std::vector<TopoDS_Edge> edges;
  for (const CurveRenewed& one : fitted) edges.push_back(one.edge);
  if (!edges.empty()) lower_tolerances(solid, edges);
  return fitted;
}

}  // namespace octet
