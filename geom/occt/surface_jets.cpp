// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a surface that is no quadric or torus.
#include "geom/occt/surface_jets.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "geom/occt/canonical.h"
#include "geom/occt/curve_jets.h"
#include "geom/occt/spline_spans.h"

namespace octet {
namespace {

SurfaceJet jet_of(const Geom_Surface& surface, const Vec2& uv, int derivatives) {
  SurfaceJet jet;
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  if (derivatives == 0) {
    surface.D0(uv.x(), uv.y(), p);
  } else if (derivatives == 1) {
    surface.D1(uv.x(), uv.y(), p, du, dv);
  } else {
    surface.D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
    jet.duu = to_vec(duu);
    jet.duv = to_vec(duv);
    jet.dvv = to_vec(dvv);
  }
  jet.p = to_vec(p);
  jet.du = to_vec(du);
  jet.dv = to_vec(dv);
  return jet;
}

/// curve(u) + v direction.
SurfaceJet extruded(const CurveJets& curve, const Vec3& direction, const Vec2& uv, int derivatives) {
  const CurveJet c = curve.evaluate(uv.x(), derivatives);
  SurfaceJet jet;
  jet.p = c.p + uv.y() * direction;
  jet.du = c.d1;
  if (derivatives > 0) jet.dv = direction;
  jet.duu = c.d2;
  return jet;
}

/// curve(v) turned by u about the axis.
SurfaceJet turned(const CurveJets& curve, const Vec3& origin, const Vec3& axis, const Vec2& uv,
                  int derivatives) {
  const CurveJet c = curve.evaluate(uv.y(), derivatives);
  const double cosine = std::cos(uv.x()), sine = std::sin(uv.x());
  const auto turn = [&](const Vec3& w, Vec3& along_u, Vec3& along_uu) -> Vec3 {
    const Vec3 up = w.dot(axis) * axis, out = w - up, side = axis.cross(w);
    along_u = cosine * side - sine * out;
    along_uu = -cosine * out - sine * side;
    return up - along_uu;
  };
  SurfaceJet jet;
  Vec3 unused, unused_too;
  jet.p = origin + turn(c.p - origin, jet.du, jet.duu);
  if (derivatives > 0) jet.dv = turn(c.d1, jet.duv, unused);
  if (derivatives > 1) jet.dvv = turn(c.d2, unused, unused_too);
  if (derivatives < 2) jet.duu = jet.duv = Vec3::Zero();
  if (derivatives < 1) jet.du = Vec3::Zero();
  return jet;
}

/// Ends of [lo, hi] and the knots between, periods repeated.
std::vector<double> breaks_of(const std::vector<double>& knots, double lo, double hi, double period) {
  std::vector<double> breaks = {lo, hi};
  const double nearly = 1e-9 * (hi - lo);
  for (const double knot : knots) {
    if (period <= 0.0) {
      if (knot > lo + nearly && knot < hi - nearly) breaks.push_back(knot);
      continue;
    }
    for (double k = knot + period * std::ceil((lo - knot) / period); k < hi - nearly; k += period)
      if (k > lo + nearly) breaks.push_back(k);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end(), [&](double a, double b) { return b - a < nearly; }),
               breaks.end());
  breaks.back() = hi;
  return breaks;
}

}  // namespace

SurfaceJets::SurfaceJets(const Handle(Geom_Surface) & surface) : surface_(surface) {
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface); !offset.IsNull()) {
    const SurfaceJets basis(offset->BasisSurface());
    u_knots_ = basis.u_knots_;
    v_knots_ = basis.v_knots_;
  } else if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
             !trimmed.IsNull()) {
    *this = SurfaceJets(trimmed->BasisSurface());
    return;
  } else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
             !extrusion.IsNull()) {
    const auto curve = std::make_shared<const CurveJets>(extrusion->BasisCurve());
    u_knots_ = curve->knots();
    evaluate_ = [curve, direction = to_vec(extrusion->Direction().XYZ())](const Vec2& uv, int derivatives) {
      return extruded(*curve, direction, uv, derivatives);
    };
    return;
  } else if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
             !revolution.IsNull()) {
    const auto curve = std::make_shared<const CurveJets>(revolution->BasisCurve());
    v_knots_ = curve->knots();
    evaluate_ = [curve, origin = to_vec(revolution->Location()),
                 axis = to_vec(revolution->Direction().XYZ())](const Vec2& uv, int derivatives) {
      return turned(*curve, origin, axis, uv, derivatives);
    };
    return;
  } else if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull()) {
    for (int i = 1; i <= spline->NbUKnots(); ++i) u_knots_.push_back(spline->UKnot(i));
    for (int i = 1; i <= spline->NbVKnots(); ++i) v_knots_.push_back(spline->VKnot(i));
  }
  if (const std::shared_ptr<const SplineSpans> spans = SplineSpans::make(surface)) {
    runs_on_ = true;
    evaluate_ = [spans](const Vec2& uv, int derivatives) { return spans->evaluate(uv, derivatives); };
    return;
  }
  evaluate_ = [surface](const Vec2& uv, int derivatives) { return jet_of(*surface, uv, derivatives); };
}

std::vector<double> SurfaceJets::u_breaks(const UvCell& range) const {
  return breaks_of(u_knots_, range.lo.x(), range.hi.x(), surface_->IsUPeriodic() ? surface_->UPeriod() : 0.0);
}

std::vector<double> SurfaceJets::v_breaks(const UvCell& range) const {
  return breaks_of(v_knots_, range.lo.y(), range.hi.y(), surface_->IsVPeriodic() ? surface_->VPeriod() : 0.0);
}

const char* SurfaceJets::kind() const {
  if (surface_->IsKind(STANDARD_TYPE(Geom_BSplineSurface))) return "b-spline";
  if (surface_->IsKind(STANDARD_TYPE(Geom_BezierSurface))) return "bezier";
  if (surface_->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) return "extrusion";
  if (surface_->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return "revolution";
  if (surface_->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) return "offset";
  return "other";
}

}  // namespace octet
