// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a curve: splines as one polynomial per knot span.
#include "geom/occt/curve_jets.h"

#include <GeomConvert.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/bernstein.h"
#include "geom/occt/canonical.h"

namespace octet {

CurveJets::CurveJets(Handle(Geom_Curve) curve) : curve_(std::move(curve)) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve_)) curve_ = trimmed->BasisCurve();
  auto spline = Handle(Geom_BSplineCurve)::DownCast(curve_);
  if (spline.IsNull()) {
    if (Handle(Geom_BezierCurve)::DownCast(curve_).IsNull()) return;
    spline = GeomConvert::CurveToBSplineCurve(curve_);
  }
  for (int i = 1; i <= spline->NbKnots(); ++i) knots_.push_back(spline->Knot(i));
  period_ = spline->IsPeriodic() ? spline->Period() : 0.0;
  GeomConvert_BSplineCurveToBezierCurve convert(spline);
  if (convert.NbArcs() + 1 != static_cast<int>(knots_.size())) return;
  const BernsteinMatrix matrix = bernstein_to_power(spline->Degree());
  for (int arc = 1; arc <= convert.NbArcs(); ++arc) {
    const Handle(Geom_BezierCurve) piece = convert.Arc(arc);
    if (piece->Degree() != spline->Degree()) return;
    const Vec3 middle = 0.5 * (to_vec(piece->StartPoint()) + to_vec(piece->EndPoint()));
    centres_.push_back(middle);
    double terms = 0.0, size = 0.0;
    for (int k = 0; k <= piece->Degree(); ++k) {
      WidePoint sum = WidePoint::Zero();
      for (int i = 0; i <= piece->Degree(); ++i) {
        const double w = piece->Weight(i + 1);
        const Vec3 r = w * (to_vec(piece->Pole(i + 1)) - middle);
        size = std::max(size, r.lpNorm<Eigen::Infinity>());
        sum += matrix[k][i] * WidePoint(r.x(), r.y(), r.z(), w);
      }
      coefficients_.push_back(sum.cast<double>());
      terms += std::ldexp(coefficients_.back().head<3>().lpNorm<Eigen::Infinity>(), -k);
    }
    if (loses_digits(terms, size)) return;
  }
  rational_ = spline->IsRational();
  degree_ = spline->Degree();
}

CurveJet CurveJets::evaluate(double t, int derivatives) const {
  CurveJet jet;
  if (degree_ < 0) {
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    if (derivatives == 0)
      curve_->D0(t, p);
    else if (derivatives == 1)
      curve_->D1(t, p, d1);
    else if (derivatives == 2)
      curve_->D2(t, p, d1, d2);
    else
      curve_->D3(t, p, d1, d2, d3);
    return {to_vec(p), to_vec(d1), to_vec(d2), to_vec(d3)};
  }
  if (period_ > 0.0 && (t < knots_.front() || t > knots_.back()))
    t -= period_ * std::floor((t - knots_.front()) / period_);
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
  const auto span = static_cast<std::size_t>(next - knots_.begin()) - 1;
  const double width = knots_[span + 1] - knots_[span];
  const double s = (t - 0.5 * (knots_[span] + knots_[span + 1])) / width;
  const auto count = static_cast<std::size_t>(degree_) + 1;
  const Eigen::Vector4d* const c = coefficients_.data() + span * count;
  HornerRow row;
  for (std::size_t k = count; k-- > 0;) row.push(c[k], s, derivatives);
  const auto head = [](const Eigen::Vector4d& x) { return Vec3(x.head<3>()); };
  const double w = rational_ ? row.value[3] : 1.0;
  const Vec3 p = head(row.value) / w;
  jet.p = p + centres_[span];
  if (derivatives == 0) return jet;
  const Eigen::Vector4d d1 = row.first / width, d2 = row.second * (2.0 / (width * width));
  const double w1 = rational_ ? d1[3] : 0.0, w2 = rational_ ? d2[3] : 0.0;
  jet.d1 = (head(d1) - w1 * p) / w;
  if (derivatives > 1) jet.d2 = (head(d2) - 2.0 * w1 * jet.d1 - w2 * p) / w;
  if (derivatives > 2) {
    const Eigen::Vector4d d3 = row.third * (6.0 / (width * width * width));
    const double w3 = rational_ ? d3[3] : 0.0;
    jet.d3 = (head(d3) - 3.0 * w1 * jet.d2 - 3.0 * w2 * jet.d1 - w3 * p) / w;
  }
  return jet;
}

}  // namespace octet
