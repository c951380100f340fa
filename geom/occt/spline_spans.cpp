// SPDX-License-Identifier: BSD-3-Clause
// B-spline and Bezier surfaces as one polynomial patch per knot span.
#include "geom/occt/spline_spans.h"

#include <GeomConvert.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/bernstein.h"

namespace octet {
namespace {

constexpr std::size_t kMaxCoefficients = 4'000'000;  // 128 MB

std::vector<double> to_vector(const TColStd_Array1OfReal& array) {
  std::vector<double> items;
  for (int i = array.Lower(); i <= array.Upper(); ++i) items.push_back(array(i));
  return items;
}

Vec3 middle_of(const Geom_BezierSurface& patch) {
  Box3 box;
  for (const int i : {1, patch.NbUPoles()})
    for (const int j : {1, patch.NbVPoles()}) {
      const gp_Pnt p = patch.Pole(i, j);
      box.add({p.X(), p.Y(), p.Z()});
    }
  return box.centre();
}

/// Homogeneous coefficients about `middle`, by power of u, then of v.
void append_powers(const Geom_BezierSurface& patch, const Vec3& middle, const BernsteinMatrix& mu,
                   const BernsteinMatrix& mv, std::vector<Eigen::Vector4d>& coefficients) {
  for (int k = 0; k <= patch.UDegree(); ++k)
    for (int l = 0; l <= patch.VDegree(); ++l) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      for (int i = 0; i <= patch.UDegree(); ++i)
        for (int j = 0; j <= patch.VDegree(); ++j) {
          const gp_Pnt p = patch.Pole(i + 1, j + 1);
          const double w = patch.Weight(i + 1, j + 1);
          const Vec3 r = w * (Vec3(p.X(), p.Y(), p.Z()) - middle);
          sum += mu[k][i] * mv[l][j] * Eigen::Vector4d(r.x(), r.y(), r.z(), w);
        }
      coefficients.push_back(sum);
    }
}

}  // namespace

std::unique_ptr<const SplineSpans> SplineSpans::make(const Handle(Geom_Surface) & surface) {
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) {
    if (Handle(Geom_BezierSurface)::DownCast(surface).IsNull()) return nullptr;
    spline = GeomConvert::SurfaceToBSplineSurface(surface);
  }
  if (spline->UDegree() > kMaxSpanDegree || spline->VDegree() > kMaxSpanDegree) return nullptr;
  auto result = std::make_unique<SplineSpans>();
  result->u_.degree = spline->UDegree();
  result->v_.degree = spline->VDegree();
  result->u_.period = spline->IsUPeriodic() ? spline->UPeriod() : 0.0;
  result->v_.period = spline->IsVPeriodic() ? spline->VPeriod() : 0.0;
  result->rational_ = spline->IsURational() || spline->IsVRational();
  GeomConvert_BSplineSurfaceToBezierSurface convert(spline);
  const int u_spans = convert.NbUPatches(), v_spans = convert.NbVPatches();
  const auto per_span = static_cast<std::size_t>((spline->UDegree() + 1) * (spline->VDegree() + 1));
  if (per_span * static_cast<std::size_t>(u_spans) * static_cast<std::size_t>(v_spans) > kMaxCoefficients)
    return nullptr;
  TColStd_Array1OfReal u_knots(1, u_spans + 1), v_knots(1, v_spans + 1);
  convert.UKnots(u_knots);
  convert.VKnots(v_knots);
  result->u_.knots = to_vector(u_knots);
  result->v_.knots = to_vector(v_knots);
  const BernsteinMatrix mu = bernstein_to_power(spline->UDegree()),
                        mv = bernstein_to_power(spline->VDegree());
  for (int a = 1; a <= u_spans; ++a)
    for (int b = 1; b <= v_spans; ++b) {
      const Handle(Geom_BezierSurface) patch = convert.Patch(a, b);
      if (patch->UDegree() != spline->UDegree() || patch->VDegree() != spline->VDegree()) return nullptr;
      result->centres_.push_back(middle_of(*patch));
      append_powers(*patch, result->centres_.back(), mu, mv, result->coefficients_);
    }
  return result;
}

std::size_t SplineSpans::Axis::locate(double t, double& local, double& width) const {
  if (period > 0.0 && (t < knots.front() || t > knots.back()))
    t -= period * std::floor((t - knots.front()) / period);
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
  const auto span = static_cast<std::size_t>(next - knots.begin()) - 1;
  width = knots[span + 1] - knots[span];
  local = (t - 0.5 * (knots[span] + knots[span + 1])) / width;
  return span;
}

SurfaceJet SplineSpans::evaluate(const Vec2& uv, int derivatives) const {
  double s = 0.0, r = 0.0, hu = 1.0, hv = 1.0;
  const std::size_t a = u_.locate(uv.x(), s, hu), b = v_.locate(uv.y(), r, hv);
  const auto nu = static_cast<std::size_t>(u_.degree) + 1, nv = static_cast<std::size_t>(v_.degree) + 1;
  const std::size_t span = a * (v_.knots.size() - 1) + b;
  const Eigen::Vector4d* c = coefficients_.data() + span * nu * nv;
  HornerRow at, along_v, along_vv;
  for (std::size_t k = nu; k-- > 0;) {
    HornerRow row;
    for (std::size_t l = nv; l-- > 0;) row.push(c[k * nv + l], r, derivatives);
    at.push(row.value, s, derivatives);
    if (derivatives > 0) along_v.push(row.first, s, derivatives - 1);
    if (derivatives > 1) along_vv.push(row.second, s, 0);
  }
  // Horner's second row holds half of the second derivative.
  const double w = at.value[3];
  SurfaceJet jet;
  const auto head = [](const Eigen::Vector4d& x) { return Vec3(x.head<3>()); };
  const Vec3 p = rational_ ? Vec3(head(at.value) / w) : head(at.value);
  jet.p = p + centres_[span];
  if (derivatives == 0) return jet;
  const Eigen::Vector4d u1 = at.first / hu, v1 = along_v.value / hv;
  if (!rational_) {
    jet.du = head(u1);
    jet.dv = head(v1);
    if (derivatives < 2) return jet;
    jet.duu = head(at.second) * (2.0 / (hu * hu));
    jet.duv = head(along_v.first) / (hu * hv);
    jet.dvv = head(along_vv.value) * (2.0 / (hv * hv));
    return jet;
  }
  jet.du = (head(u1) - u1[3] * p) / w;
  jet.dv = (head(v1) - v1[3] * p) / w;
  if (derivatives < 2) return jet;
  const Eigen::Vector4d uu = at.second * (2.0 / (hu * hu)), mixed = along_v.first / (hu * hv),
                        vv = along_vv.value * (2.0 / (hv * hv));
  jet.duu = (head(uu) - 2.0 * u1[3] * jet.du - uu[3] * p) / w;
  jet.duv = (head(mixed) - u1[3] * jet.dv - v1[3] * jet.du - mixed[3] * p) / w;
  jet.dvv = (head(vv) - 2.0 * v1[3] * jet.dv - vv[3] * p) / w;
  return jet;
}

}  // namespace octet
