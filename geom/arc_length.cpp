// SPDX-License-Identifier: BSD-3-Clause
// Arc length along a curve, both ways.
#include "geom/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace octet {
namespace {

/// Eight point Gauss-Legendre: abscissas of [-1, 1] and weights, symmetric.
constexpr std::array<double, 4> kAbscissa{0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                          0.96028985649753623};
constexpr std::array<double, 4> kWeight{0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                        0.10122853629037626};

double gauss(const Curve& curve, double a, double b) {
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    sum += kWeight[i] * curve.derivative(middle - half * kAbscissa[i]).norm();
    sum += kWeight[i] * curve.derivative(middle + half * kAbscissa[i]).norm();
  }
  return half * sum;
}

}  // namespace

ArcLength::ArcLength(const Curve& curve, double t0, double t1) {
  const bool straight = std::strcmp(curve.kind(), "line") == 0;
  // Eight spans at least: the knots also start global searches for the nearest point.
  const int spans = straight ? 1 : 8;
  std::vector<double> ends;
  for (int i = 1; i < spans; ++i) ends.push_back(t0 + (t1 - t0) * i / spans);
  // A spline may turn back within a knot span too short for any abscissa of an even division.
  for (const double knot : curve.breaks())
    if (knot > t0 && knot < t1) ends.push_back(knot);
  std::sort(ends.begin(), ends.end());
  ends.push_back(t1);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  knot_ = {t0};
  length_ = {0.0};
  for (const double b : ends) {
    const double a = knot_.back();
    add_span(curve, a, b, gauss(curve, a, b), 0);
  }
}

void ArcLength::add_span(const Curve& curve, double a, double b, double whole, int depth) {
  constexpr int kDeepest = 12;
  constexpr double kAgree = 1e-11;
  const double middle = 0.5 * (a + b);
  const double left = gauss(curve, a, middle), right = gauss(curve, middle, b);
  if (depth == kDeepest || std::abs(left + right - whole) <= kAgree * (left + right)) {
    knot_.push_back(b);
    length_.push_back(length_.back() + left + right);
    return;
  }
  add_span(curve, a, middle, left, depth + 1);
  add_span(curve, middle, b, right, depth + 1);
}

double ArcLength::from_start(const Curve& curve, double t) const {
  const auto above = std::upper_bound(knot_.begin() + 1, knot_.end() - 1, t);
  const std::size_t span = static_cast<std::size_t>(above - knot_.begin()) - 1;
  return length_[span] + gauss(curve, knot_[span], t);
}

double ArcLength::length(const Curve& curve, double t_from, double t_to) const {
  return from_start(curve, t_to) - from_start(curve, t_from);
}

double ArcLength::parameter(const Curve& curve, double t_from, double s) const {
  const double target = from_start(curve, t_from) + s;
  if (target <= 0.0) return knot_.front();
  if (target >= total()) return knot_.back();
  const auto above = std::upper_bound(length_.begin() + 1, length_.end() - 1, target);
  const std::size_t span = static_cast<std::size_t>(above - length_.begin()) - 1;
  double lo = knot_[span], hi = knot_[span + 1];
  double t = lo + (hi - lo) * (target - length_[span]) / (length_[span + 1] - length_[span]);
  for (int i = 0; i < 60; ++i) {
    const double error = length_[span] + gauss(curve, knot_[span], t) - target;
    if (std::abs(error) <= 1e-14 * total()) break;
    (error < 0.0 ? lo : hi) = t;
    const double speed = curve.derivative(t).norm();
    const double next = t - error / speed;
    const double step = speed > 0.0 && next > lo && next < hi ? next : 0.5 * (lo + hi);
    if (step == t) break;
    t = step;
  }
  return t;
}

}  // namespace octet
