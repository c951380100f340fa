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

#include "base/wide_clones.h"
#include "geom/occt/bernstein.h"
#include "geom/occt/canonical.h"

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

/// Homogeneous coefficients about `middle`, by power of u, then of v. False where they lose digits.
bool append_powers(const Geom_BezierSurface& patch, const Vec3& middle, const BernsteinMatrix& mu,
                   const BernsteinMatrix& mv, std::vector<Eigen::Vector4d>& coefficients) {
  const int u_degree = patch.UDegree(), v_degree = patch.VDegree();
  double terms = 0.0, size = 0.0;
  std::vector<WidePoint> poles;  // by i, j
  for (int i = 0; i <= u_degree; ++i)
    for (int j = 0; j <= v_degree; ++j) {
      const double w = patch.Weight(i + 1, j + 1);
      const Vec3 r = w * (to_vec(patch.Pole(i + 1, j + 1)) - middle);
      size = std::max(size, r.lpNorm<Eigen::Infinity>());
      poles.emplace_back(r.x(), r.y(), r.z(), w);
    }
  const auto v_count = static_cast<std::size_t>(v_degree) + 1;
  std::vector<WidePoint> row(v_count);
  for (int k = 0; k <= u_degree; ++k) {
    for (std::size_t j = 0; j < v_count; ++j) {
      row[j].setZero();
      for (int i = 0; i <= u_degree; ++i)
        row[j] += mu[k][i] * poles[static_cast<std::size_t>(i) * v_count + j];
    }
    for (int l = 0; l <= v_degree; ++l) {
      WidePoint sum = WidePoint::Zero();
      for (std::size_t j = 0; j < v_count; ++j) sum += mv[l][j] * row[j];
      coefficients.push_back(sum.cast<double>());
      terms += std::ldexp(coefficients.back().head<3>().lpNorm<Eigen::Infinity>(), -k - l);
    }
  }
  return !loses_digits(terms, size);
}

/// HornerRow of homogeneous points, with as many derivatives as are asked for.
template <int kDerivatives>
struct LaneRow {
  Lanes value{}, first{}, second{}, third{};
  OCTET_LANEWISE void push(const Lanes& c, double s) {
    if constexpr (kDerivatives > 2) third = third * s + second;
    if constexpr (kDerivatives > 1) second = second * s + first;
    if constexpr (kDerivatives > 0) first = first * s + value;
    value = value * s + c;
  }
};

/// A patch and its derivatives by the places in its span, each over the factorials of its orders in u and v.
struct PatchJet {
  Eigen::Vector4d value, u, v, uu, uv, vv, uuu, uuv, uvv, vvv;
};

OCTET_LANEWISE void store(const Lanes& from, Eigen::Vector4d& to) {
  to = {from[0], from[1], from[2], from[3]};
}

template <int kDerivatives>
OCTET_LANEWISE void evaluate_patch(const Eigen::Vector4d* c, std::size_t nu, std::size_t nv, double s,
                                   double r, PatchJet& jet) {
  LaneRow<kDerivatives> at;
  LaneRow<std::max(kDerivatives - 1, 0)> along_v;
  LaneRow<std::max(kDerivatives - 2, 0)> along_vv;
  LaneRow<0> along_vvv;
  for (std::size_t k = nu; k-- > 0;) {
    LaneRow<kDerivatives> row;
    for (std::size_t l = nv; l-- > 0;) {
      const Eigen::Vector4d& p = c[k * nv + l];
      row.push(Lanes{p[0], p[1], p[2], p[3]}, r);
    }
    at.push(row.value, s);
    if constexpr (kDerivatives > 0) along_v.push(row.first, s);
    if constexpr (kDerivatives > 1) along_vv.push(row.second, s);
    if constexpr (kDerivatives > 2) along_vvv.push(row.third, s);
  }
  store(at.value, jet.value);
  if constexpr (kDerivatives > 0) {
    store(at.first, jet.u);
    store(along_v.value, jet.v);
  }
  if constexpr (kDerivatives > 1) {
    store(at.second, jet.uu);
    store(along_v.first, jet.uv);
    store(along_vv.value, jet.vv);
  }
  if constexpr (kDerivatives > 2) {
    store(at.third, jet.uuu);
    store(along_v.second, jet.uuv);
    store(along_vv.first, jet.uvv);
    store(along_vvv.value, jet.vvv);
  }
}

}  // namespace

// The work of SplineSpans::evaluate, on one patch.
namespace spline_lanes {

OCTET_WIDE_CLONES void evaluate(const Eigen::Vector4d* c, std::size_t nu, std::size_t nv, double s, double r,
                                int derivatives, PatchJet& jet) {
  if (derivatives == 0) return evaluate_patch<0>(c, nu, nv, s, r, jet);
  if (derivatives == 1) return evaluate_patch<1>(c, nu, nv, s, r, jet);
  if (derivatives == 2) return evaluate_patch<2>(c, nu, nv, s, r, jet);
  evaluate_patch<3>(c, nu, nv, s, r, jet);
}

}  // namespace spline_lanes

std::unique_ptr<const SplineSpans> SplineSpans::make(const Handle(Geom_Surface) & surface) {
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) {
    if (Handle(Geom_BezierSurface)::DownCast(surface).IsNull()) return nullptr;
    spline = GeomConvert::SurfaceToBSplineSurface(surface);
  }
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
      if (!append_powers(*patch, result->centres_.back(), mu, mv, result->coefficients_)) return nullptr;
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

SurfaceJet SplineSpans::evaluate(const Vec2& uv, int derivatives, SurfaceThirds* thirds) const {
  double s = 0.0, r = 0.0, hu = 1.0, hv = 1.0;
  const std::size_t a = u_.locate(uv.x(), s, hu), b = v_.locate(uv.y(), r, hv);
  const auto nu = static_cast<std::size_t>(u_.degree) + 1, nv = static_cast<std::size_t>(v_.degree) + 1;
  const std::size_t span = a * (v_.knots.size() - 1) + b;
  const Eigen::Vector4d* c = coefficients_.data() + span * nu * nv;
  PatchJet patch;
  spline_lanes::evaluate(c, nu, nv, s, r, derivatives, patch);
  const double w = patch.value[3];
  SurfaceJet jet;
  const auto head = [](const Eigen::Vector4d& x) { return Vec3(x.head<3>()); };
  const Vec3 p = rational_ ? Vec3(head(patch.value) / w) : head(patch.value);
  jet.p = p + centres_[span];
  if (derivatives == 0) return jet;
  const Eigen::Vector4d u1 = patch.u / hu, v1 = patch.v / hv;
  if (!rational_) {
    jet.du = head(u1);
    jet.dv = head(v1);
    if (derivatives < 2) return jet;
    jet.duu = head(patch.uu) * (2.0 / (hu * hu));
    jet.duv = head(patch.uv) / (hu * hv);
    jet.dvv = head(patch.vv) * (2.0 / (hv * hv));
    if (derivatives < 3) return jet;
    thirds->uuu = head(patch.uuu) * (6.0 / (hu * hu * hu));
    thirds->uuv = head(patch.uuv) * (2.0 / (hu * hu * hv));
    thirds->uvv = head(patch.uvv) * (2.0 / (hu * hv * hv));
    thirds->vvv = head(patch.vvv) * (6.0 / (hv * hv * hv));
    return jet;
  }
  jet.du = (head(u1) - u1[3] * p) / w;
  jet.dv = (head(v1) - v1[3] * p) / w;
  if (derivatives < 2) return jet;
  const Eigen::Vector4d uu = patch.uu * (2.0 / (hu * hu)), mixed = patch.uv / (hu * hv),
                        vv = patch.vv * (2.0 / (hv * hv));
  jet.duu = (head(uu) - 2.0 * u1[3] * jet.du - uu[3] * p) / w;
  jet.duv = (head(mixed) - u1[3] * jet.dv - v1[3] * jet.du - mixed[3] * p) / w;
  jet.dvv = (head(vv) - 2.0 * v1[3] * jet.dv - vv[3] * p) / w;
  if (derivatives < 3) return jet;
  const Eigen::Vector4d uuu = patch.uuu * (6.0 / (hu * hu * hu)), uuv = patch.uuv * (2.0 / (hu * hu * hv)),
                        uvv = patch.uvv * (2.0 / (hu * hv * hv)), vvv = patch.vvv * (6.0 / (hv * hv * hv));
  thirds->uuu = (head(uuu) - 3.0 * u1[3] * jet.duu - 3.0 * uu[3] * jet.du - uuu[3] * p) / w;
  thirds->uuv = (head(uuv) - v1[3] * jet.duu - 2.0 * u1[3] * jet.duv - 2.0 * mixed[3] * jet.du -
                 uu[3] * jet.dv - uuv[3] * p) /
                w;
  thirds->uvv = (head(uvv) - u1[3] * jet.dvv - 2.0 * v1[3] * jet.duv - 2.0 * mixed[3] * jet.dv -
                 vv[3] * jet.du - uvv[3] * p) /
                w;
  thirds->vvv = (head(vvv) - 3.0 * v1[3] * jet.dvv - 3.0 * vv[3] * jet.dv - vvv[3] * p) / w;
  return jet;
}

}  // namespace octet
