// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a surface that is no quadric or torus.
#include "geom/occt/surface_jets.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "geom/occt/canonical.h"
#include "geom/occt/curve_jets.h"

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
SurfaceJet extruded(const CurveJets& curve, const Vec3& direction, const Vec2& uv, int derivatives,
                    SurfaceThirds* thirds) {
  const CurveJet c = curve.evaluate(uv.x(), derivatives);
  SurfaceJet jet;
  jet.p = c.p + uv.y() * direction;
  jet.du = c.d1;
  if (derivatives > 0) jet.dv = direction;
  jet.duu = c.d2;
  if (derivatives > 2) *thirds = {c.d3, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  return jet;
}

/// curve(v) turned by u about the axis.
SurfaceJet turned(const CurveJets& curve, const Vec3& origin, const Vec3& axis, const Vec2& uv,
                  int derivatives, SurfaceThirds* thirds) {
  const CurveJet c = curve.evaluate(uv.y(), derivatives);
  const double cosine = std::cos(uv.x()), sine = std::sin(uv.x());
  const auto turn = [&](const Vec3& w, Vec3& along_u, Vec3& along_uu) -> Vec3 {
    const Vec3 up = w.dot(axis) * axis, out = w - up, side = axis.cross(w);
    along_u = cosine * side - sine * out;
    along_uu = -cosine * out - sine * side;
    return up - along_uu;
  };
  SurfaceJet jet;
  Vec3 duuv, duvv, unused;
  jet.p = origin + turn(c.p - origin, jet.du, jet.duu);
  if (derivatives > 0) jet.dv = turn(c.d1, jet.duv, duuv);
  if (derivatives > 1) jet.dvv = turn(c.d2, duvv, unused);
  if (derivatives > 2) *thirds = {-jet.du, duuv, duvv, turn(c.d3, unused, unused)};
  if (derivatives < 2) jet.duu = jet.duv = Vec3::Zero();
  if (derivatives < 1) jet.du = Vec3::Zero();
  return jet;
}

/// The point `distance` off a surface along its normal, with one derivative fewer than the basis has; nothing
/// where du x dv is not longer than `least`.
std::optional<SurfaceJet> moved_out(const SurfaceJet& basis, const SurfaceThirds& thirds, double distance,
                                    double least, int derivatives) {
  const Vec3 cross = basis.du.cross(basis.dv);
  const double length = cross.norm();
  if (!(length > least)) return std::nullopt;
  const Vec3 n = cross / length;
  SurfaceJet jet;
  jet.p = basis.p + distance * n;
  if (derivatives < 1) return jet;
  // cross = length n, differentiated; the length's derivatives are the parts along n.
  const Vec3 cross_u = basis.duu.cross(basis.dv) + basis.du.cross(basis.duv),
             cross_v = basis.duv.cross(basis.dv) + basis.du.cross(basis.dvv);
  const double length_u = cross_u.dot(n), length_v = cross_v.dot(n);
  const Vec3 n_u = (cross_u - length_u * n) / length, n_v = (cross_v - length_v * n) / length;
  jet.du = basis.du + distance * n_u;
  jet.dv = basis.dv + distance * n_v;
  if (derivatives < 2) return jet;
  const Vec3 cross_uu =
      thirds.uuu.cross(basis.dv) + 2.0 * basis.duu.cross(basis.duv) + basis.du.cross(thirds.uuv);
  const Vec3 cross_uv = thirds.uuv.cross(basis.dv) + basis.duu.cross(basis.dvv) + basis.du.cross(thirds.uvv);
  const Vec3 cross_vv =
      thirds.uvv.cross(basis.dv) + 2.0 * basis.duv.cross(basis.dvv) + basis.du.cross(thirds.vvv);
  const auto second = [&](const Vec3& c, const Vec3& c_a, double length_a, const Vec3& n_a, double length_b,
                          const Vec3& n_b) -> Vec3 {
    const double along = c.dot(n) + c_a.dot(n_b);
    return (c - along * n - length_a * n_b - length_b * n_a) / length;
  };
  jet.duu = basis.duu + distance * second(cross_uu, cross_u, length_u, n_u, length_u, n_u);
  jet.duv = basis.duv + distance * second(cross_uv, cross_u, length_u, n_u, length_v, n_v);
  jet.dvv = basis.dvv + distance * second(cross_vv, cross_v, length_v, n_v, length_v, n_v);
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

/// Of |du x dv|: below it OCCT looks for the limit of an offset's normal.
constexpr double kSingular = 1e-6;

/// The greatest |du x dv| of a few places; 0 for surfaces without end, whose parameters have no middle.
double typical_cross(const SurfaceJets& jets) {
  constexpr int kPlaces = 5;
  constexpr double kEndless = 1e10;
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0, most = 0.0;
  jets.surface()->Bounds(u0, u1, v0, v1);
  if (jets.surface()->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) v0 = v1 = 0.0;
  if (u1 - u0 > kEndless || v1 - v0 > kEndless) return 0.0;
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kPlaces; ++j) {
      const Vec2 share((i + 0.5) / kPlaces, (j + 0.5) / kPlaces);
      const SurfaceJet jet = jets.evaluate({u0 + share.x() * (u1 - u0), v0 + share.y() * (v1 - v0)}, 1);
      most = std::max(most, jet.du.cross(jet.dv).norm());
    }
  return most;
}

}  // namespace

SurfaceJets::SurfaceJets(const Handle(Geom_Surface) & surface) : surface_(surface) {
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface); !offset.IsNull()) {
    set_offset(*offset);
    return;
  } else if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
             !trimmed.IsNull()) {
    *this = SurfaceJets(trimmed->BasisSurface());
    return;
  } else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
             !extrusion.IsNull()) {
    const auto curve = std::make_shared<const CurveJets>(extrusion->BasisCurve());
    u_knots_ = curve->knots();
    has_thirds_ = true;
    evaluate_ = [curve, direction = to_vec(extrusion->Direction().XYZ())](const Vec2& uv, int derivatives,
                                                                          SurfaceThirds* thirds) {
      return extruded(*curve, direction, uv, derivatives, thirds);
    };
    return;
  } else if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
             !revolution.IsNull()) {
    const auto curve = std::make_shared<const CurveJets>(revolution->BasisCurve());
    v_knots_ = curve->knots();
    has_thirds_ = true;
    evaluate_ = [curve, origin = to_vec(revolution->Location()),
                 axis = to_vec(revolution->Direction().XYZ())](const Vec2& uv, int derivatives,
                                                               SurfaceThirds* thirds) {
      return turned(*curve, origin, axis, uv, derivatives, thirds);
    };
    return;
  } else if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull()) {
    for (int i = 1; i <= spline->NbUKnots(); ++i) u_knots_.push_back(spline->UKnot(i));
    for (int i = 1; i <= spline->NbVKnots(); ++i) v_knots_.push_back(spline->VKnot(i));
  }
  if (const std::shared_ptr<const SplineSpans> spans = SplineSpans::make(surface)) {
    has_thirds_ = true;
    set_runs_on();
    evaluate_ = [spans](const Vec2& uv, int derivatives, SurfaceThirds* thirds) {
      return spans->evaluate(uv, derivatives, thirds);
    };
    return;
  }
  evaluate_ = [surface](const Vec2& uv, int derivatives, SurfaceThirds*) {
    return jet_of(*surface, uv, derivatives);
  };
}

/// The size of a polynomial of degree n grows beyond its span like that of Chebyshev's: by a span over n^2
/// about fourfold, by a hundred spans at n = 9 by a factor of 10^23.
void SurfaceJets::set_runs_on() {
  double lo[2], hi[2];
  surface_->Bounds(lo[0], hi[0], lo[1], hi[1]);
  int degree[2] = {1, 1};
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface_); !spline.IsNull())
    degree[0] = spline->UDegree(), degree[1] = spline->VDegree();
  else if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface_); !bezier.IsNull())
    degree[0] = bezier->UDegree(), degree[1] = bezier->VDegree();
  const std::vector<double>* const knots[2] = {&u_knots_, &v_knots_};
  for (int axis = 0; axis < 2; ++axis) {
    const std::vector<double> breaks = breaks_of(*knots[axis], lo[axis], hi[axis], 0.0);
    const double share = 1.0 / (degree[axis] * degree[axis]);
    runs_on_[axis] = {share * (breaks[1] - breaks[0]), share * (breaks.back() - breaks[breaks.size() - 2])};
  }
}

void SurfaceJets::set_offset(const Geom_OffsetSurface& offset) {
  SurfaceJets basis(offset.BasisSurface());
  u_knots_ = basis.u_knots_;
  v_knots_ = basis.v_knots_;
  const double least = basis.has_thirds_ ? kSingular * typical_cross(basis) : 0.0;
  if (least <= 0.0) {
    evaluate_ = [surface = surface_](const Vec2& uv, int derivatives, SurfaceThirds*) {
      return jet_of(*surface, uv, derivatives);
    };
    return;
  }
  evaluate_ = [surface = surface_, basis = std::move(basis.evaluate_), distance = offset.Offset(), least](
                  const Vec2& uv, int derivatives, SurfaceThirds*) {
    SurfaceThirds thirds;
    const SurfaceJet jet = basis(uv, derivatives + 1, &thirds);
    const std::optional<SurfaceJet> moved = moved_out(jet, thirds, distance, least, derivatives);
    return moved ? *moved : jet_of(*surface, uv, derivatives);
  };
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
