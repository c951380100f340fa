// SPDX-License-Identifier: BSD-3-Clause
// Nearest points of the surface along an edge, from where the old curve is, and a spline through them.
#include "geom/occt/loose_curves.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "geom/occt/canonical.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/curve_pieces.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/surface_foot.h"

namespace octet {
namespace {

/// A new curve must leave no more than this share of the gap.
constexpr double kMuchBetter = 0.2;
/// More pieces win nothing where the curve is off by hardly more than the edge itself is off the face.
constexpr double kAsOff = 1.05;
constexpr int kFewest = 8, kMost = 256;

/// Interior knots in u and in v at which a surface is not twice continuously differentiable.
std::array<std::vector<double>, 2> rough_knots(const Geom_BSplineSurface& surface) {
  std::array<std::vector<double>, 2> knots;
  for (int i = surface.FirstUKnotIndex() + 1; i < surface.LastUKnotIndex(); ++i)
    if (surface.UDegree() - surface.UMultiplicity(i) < 2) knots[0].push_back(surface.UKnot(i));
  for (int i = surface.FirstVKnotIndex() + 1; i < surface.LastVKnotIndex(); ++i)
    if (surface.VDegree() - surface.VMultiplicity(i) < 2) knots[1].push_back(surface.VKnot(i));
  return knots;
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
  [[nodiscard]] Handle(Geom2d_Curve) best(double gap, double near) {
    Handle(Geom2d_Curve) best;
    double least = kMuchBetter * gap;
    breaks_ = breaks(least);
    for (int pieces = kFewest; pieces <= kMost; pieces *= 2) {
      double edge_off = 0.0;
      const Handle(Geom2d_BSplineCurve) curve = through(pieces, kMuchBetter * gap, edge_off);
      if (curve.IsNull() || edge_off > kMuchBetter * gap) break;
      const double off = std::max(edge_off, gap_between(*curve));
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

  /// The point of the surface nearest to the edge at a share of it. Where the old curve is farther off than
  /// `enough` its nearest point may be another: then that beside `last`, if there is one, is tried.
  [[nodiscard]] Vec2 foot_at(double share, const Vec2* last, double enough, double& edge_off) const {
    const gp_Pnt2d seed = on_face_->Value(s0_ + share * (s1_ - s0_));
    const gp_Pnt point = in_space_->Value(at(share));
    const auto off = [&](const Vec2& uv) { return surface_->Value(uv[0], uv[1]).Distance(point); };
    Vec2 uv = foot_from(*surface_, bounds_, to_vec(point), Vec2(seed.X(), seed.Y()));
    if (last != nullptr && off(uv) > enough) {
      const Vec2 next = foot_from(*surface_, bounds_, to_vec(point), *last);
      if (off(next) < off(uv)) uv = next;
    }
    edge_off = std::max(edge_off, off(uv));
    return uv;
  }

  /// Where the edge crosses a line of the surface at which its second derivatives jump, as splines of circles
  /// have them: shares of the edge, ascending, 0 and 1 among them.
  [[nodiscard]] std::vector<double> breaks(double enough) const {
    constexpr int kSteps = 32, kHalvings = 48;
    constexpr double kHit = 1e-12;
    std::vector<double> shares{0.0, 1.0};
    const Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface_);
    if (spline.IsNull()) return shares;
    const std::array<std::vector<double>, 2> knots = rough_knots(*spline);
    if (knots[0].empty() && knots[1].empty()) return shares;
    double unused = 0.0;
    Vec2 before = foot_at(0.0, nullptr, enough, unused);
    for (int i = 1; i <= kSteps; ++i) {
      const double low = static_cast<double>(i - 1) / kSteps, high = static_cast<double>(i) / kSteps;
      const Vec2 after = foot_at(high, &before, enough, unused);
      for (int k = 0; k < 2; ++k)
        for (const double knot : knots[static_cast<std::size_t>(k)]) {
          if (std::abs(after[k] - knot) <= kHit) shares.push_back(high);
          if ((before[k] - knot) * (after[k] - knot) >= 0.0) continue;
          double from = low, to = high;
          for (int halving = 0; halving < kHalvings; ++halving) {
            const double middle = 0.5 * (from + to);
            const bool below = foot_at(middle, &before, enough, unused)[k] < knot;
            (below == (before[k] < knot) ? from : to) = middle;
          }
          shares.push_back(0.5 * (from + to));
        }
      before = after;
    }
    std::sort(shares.begin(), shares.end());
    const auto same = [](double a, double b) { return b - a < 1e-6; };
    shares.erase(std::unique(shares.begin(), shares.end(), same), shares.end());
    shares.back() = 1.0;
    return shares;
  }

  /// `edge_off`: how far the edge is from the surface at the points, of which `enough` is near.
  [[nodiscard]] Handle(Geom2d_BSplineCurve) through(int pieces, double enough, double& edge_off) const {
    CurvePieces joined;
    std::optional<Vec2> last;
    for (std::size_t b = 1; b < breaks_.size(); ++b) {
      const double low = breaks_[b - 1], length = breaks_[b] - low;
      const int count = std::max(4, static_cast<int>(std::lround(pieces * length)));
      const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count + 1);
      const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count + 1);
      for (int i = 0; i <= count; ++i) {
        const double share = low + length * i / count;
        last = foot_at(share, last ? &*last : nullptr, enough, edge_off);
        points->SetValue(i + 1, gp_Pnt2d((*last)[0], (*last)[1]));
        parameters->SetValue(i + 1, at(share));
      }
      try {
        Geom2dAPI_Interpolate fit(points, parameters, false, Precision::PConfusion());
        fit.Perform();
        if (!fit.IsDone()) return {};
        joined.add(*fit.Curve());
      } catch (const Standard_Failure&) {
        return {};  // points that coincide in (u,v): no curve through them
      }
    }
    return joined.curve();
  }

  /// Largest distance at equal parameter, between the points that the curve was made through.
  [[nodiscard]] double gap_between(const Geom2d_BSplineCurve& curve) const {
    constexpr int kBetween = 4;
    double gap = 0.0;
    for (int k = 1; k < curve.NbKnots(); ++k)
      for (int i = 1; i < kBetween; ++i) {
        const double t = curve.Knot(k) + (curve.Knot(k + 1) - curve.Knot(k)) * i / kBetween;
        const gp_Pnt2d uv = curve.Value(t);
        gap = std::max(gap, surface_->Value(uv.X(), uv.Y()).Distance(in_space_->Value(t)));
      }
    return gap;
  }

  double t0_ = 0.0, t1_ = 0.0, s0_ = 0.0, s1_ = 0.0;
  Handle(Geom_Curve) in_space_;
  Handle(Geom2d_Curve) on_face_;
  Handle(Geom_Surface) surface_;
  SurfaceBounds bounds_;
  std::vector<double> breaks_;  ///< shares of the edge between which the curve is smooth
};

bool can_be_fitted(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  return !BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face);
}

/// A new curve for a seam as the face's other side has it: as far away as the two are now.
Handle(Geom2d_Curve)
    beside(const Handle(Geom2d_Curve) & curve, const TopoDS_Edge& seam, const TopoDS_Face& face) {
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) one = BRep_Tool::CurveOnSurface(seam, face, first, last);
  const Handle(Geom2d_Curve) other =
      BRep_Tool::CurveOnSurface(TopoDS::Edge(seam.Reversed()), face, first, last);
  const gp_Vec2d off(one->Value(first), other->Value(first));
  return Handle(Geom2d_Curve)::DownCast(curve->Translated(off));
}

bool fit_within(double near, const TopoDS_Edge& edge, const TopoDS_Face& face, double gap) {
  Fit fit(edge, face);
  if (!fit.possible()) return false;
  const Handle(Geom2d_Curve) curve = fit.best(gap, near);
  if (curve.IsNull()) return false;
  const BRep_Builder builder;
  if (BRep_Tool::IsClosed(edge, face))
    builder.UpdateEdge(edge, curve, beside(curve, edge, face), face, Precision::Confusion());
  else
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

/// No more than about twice the area over the perimeter: for the area, the length of its vector, which edges
/// alone tell (that of a face around an axis is short, or nothing).
double least_width(const TopoDS_Face& face) {
  constexpr int kPieces = 24;
  Vec3 twice_area = Vec3::Zero();
  double perimeter = 0.0;
  std::optional<Vec3> origin;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) return 0.0;
    const double way = edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    Vec3 from = to_vec(curve->Value(first));
    if (!origin) origin = from;
    for (int i = 1; i <= kPieces; ++i) {
      const Vec3 to = to_vec(curve->Value(first + (last - first) * i / kPieces));
      twice_area += way * (from - *origin).cross(to - *origin);
      perimeter += (to - from).norm();
      from = to;
    }
  }
  return perimeter > 0.0 ? twice_area.norm() / perimeter : 0.0;
}

/// Whether the face is no wider than what its curves are off: whatever its surface is, it is an edge to the
/// faces beside it, and the tolerance of its sides says so.
bool is_strip(const TopoDS_Face& face, const std::vector<CurveRenewed>& loose) {
  constexpr double kOfWidth = 0.25;
  double widest = 0.0;
  for (const CurveRenewed& one : loose) widest = std::max(widest, one.gap);
  constexpr double kSurely = 2.0;
  return widest * kSurely > kOfWidth * least_width(face) && widest > kOfWidth * width_of(face);
}

}  // namespace

bool fit_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const TopoDS_Edge along = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  if (BRep_Tool::Degenerated(along)) return false;
  const double gap = curve_gap(along, forward);
  return gap > Precision::Confusion() && fit_within(Precision::Confusion(), along, forward, gap);
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
