// SPDX-License-Identifier: BSD-3-Clause
// Lines, circles and ellipses in closed form.
#include "geom/conics.h"

#include <algorithm>
#include <limits>

#include "base/constants.h"

namespace octet {
namespace {

class Line final : public Curve {
 public:
  Line(const Vec3& origin, const Vec3& direction, double t0, double t1)
      : origin_(origin), direction_(direction), t0_(t0), t1_(t1) {}

  Vec3 point(double t) const override { return origin_ + t * direction_; }
  Vec3 derivative(double) const override { return direction_; }
  double project(const Vec3& p, double) const override {
    return std::clamp((p - origin_).dot(direction_) / direction_.squaredNorm(), t0_, t1_);
  }
  void cut(const Vec3& normal, double offset, std::vector<double>& parameters) const override {
    const double d = direction_.dot(normal);
    // A line in the plane (or off it, parallel) has no cut of its own.
    if (std::abs(d) <= kEps * direction_.norm()) return;
    const double t = (offset - origin_.dot(normal)) / d;
    if (t >= t0_ && t <= t1_) parameters.push_back(t);
  }
  const char* kind() const override { return "line"; }

 private:
  Vec3 origin_, direction_;
  double t0_, t1_;
};

/// Circle when both radii agree.
class Ellipse final : public Curve {
 public:
  Ellipse(const Axes3& axes, double major, double minor, double t0, double t1)
      : axes_(axes), a_(major), b_(minor), t0_(t0), t1_(t1) {}

  Vec3 point(double t) const override {
    return axes_.origin + a_ * std::cos(t) * axes_.x + b_ * std::sin(t) * axes_.y;
  }
  Vec3 derivative(double t) const override { return b_ * std::cos(t) * axes_.y - a_ * std::sin(t) * axes_.x; }

  double project(const Vec3& p, double hint) const override {
    const Vec3 d = p - axes_.origin;
    const double x = d.dot(axes_.x), y = d.dot(axes_.y);
    if (a_ == b_ && std::hypot(x, y) <= 4.0 * kEps * a_) return std::clamp(hint, t0_, t1_);
    const double t = a_ == b_ ? std::atan2(y, x) : ellipse_foot(x, y);
    return into_range(t, p, hint);
  }

  void cut(const Vec3& normal, double offset, std::vector<double>& parameters) const override {
    const double c = a_ * axes_.x.dot(normal), s = b_ * axes_.y.dot(normal);
    const double height = axes_.origin.dot(normal), w = offset - height;
    const double amplitude = std::hypot(c, s);
    const double noise = 16.0 * kEps * (std::abs(offset) + std::abs(height) + a_);
    if (amplitude <= noise || std::abs(w) > amplitude + noise) return;
    const double phase = std::atan2(s, c);
    const double half = std::acos(std::clamp(w / amplitude, -1.0, 1.0));
    const std::size_t first = parameters.size();
    add_if_in_range(phase - half, parameters);
    if (amplitude - std::abs(w) > noise) add_if_in_range(phase + half, parameters);
    std::sort(parameters.begin() + static_cast<std::ptrdiff_t>(first), parameters.end());
  }
  const char* kind() const override { return a_ == b_ ? "circle" : "ellipse"; }

 private:
  void add_if_in_range(double t, std::vector<double>& parameters) const {
    const double w = wrap_angle(t, t0_);
    if (w <= t1_) parameters.push_back(w);
  }

  /// The angle of a foot, or the nearer end when it lies off the arc.
  [[nodiscard]] double into_range(double t, const Vec3& p, double hint) const {
    const double w = wrap_angle_near(t, t0_, hint);
    if (w <= t1_) return w;
    if (a_ != b_) return nearest_on_arc(p);
    return (point(t0_) - p).squaredNorm() <= (point(t1_) - p).squaredNorm() ? t0_ : t1_;
  }

  /// The nearest of the arc when the whole ellipse's foot is off it: an end, or a lesser minimum between
  /// samples, where the distance's slope is bisected.
  [[nodiscard]] double nearest_on_arc(const Vec3& p) const {
    constexpr int kSteps = 32;
    const auto at = [&](int i) { return i == kSteps ? t1_ : t0_ + (t1_ - t0_) * i / kSteps; };
    const auto slope = [&](double t) { return (point(t) - p).dot(derivative(t)); };
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSteps; ++i) {
      const double d2 = (point(at(i)) - p).squaredNorm();
      if (d2 >= least) continue;
      least = d2;
      best = i;
    }
    double lo = at(std::max(best - 1, 0)), hi = at(std::min(best + 1, kSteps));
    if (best == 0 && slope(lo) >= 0.0) return lo;
    if (best == kSteps && slope(hi) <= 0.0) return hi;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (lo + hi);
      (slope(middle) < 0.0 ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
  }

  /// Foot of (x, y) on the whole ellipse: in the first quadrant the distance's derivative has one root,
  /// between the axes, and bisection-guarded Newton finds it.
  [[nodiscard]] double ellipse_foot(double x, double y) const {
    const double px = std::abs(x), py = std::abs(y), k = (a_ - b_) * (a_ + b_);
    const auto slope = [&](double t) {
      return a_ * px * std::sin(t) - b_ * py * std::cos(t) - k * std::sin(t) * std::cos(t);
    };
    double lo = 0.0, hi = 0.5 * std::numbers::pi;
    double t = std::atan2(a_ * py, b_ * px);
    if (!(t > lo && t < hi)) t = 0.5 * (lo + hi);
    for (int i = 0; i < 60 && hi - lo > 4.0 * kEps; ++i) {
      const double f = slope(t);
      if (f == 0.0) break;
      (f < 0.0 ? lo : hi) = t;
      const double df = a_ * px * std::cos(t) + b_ * py * std::sin(t) - k * std::cos(2.0 * t);
      const double next = t - f / df;
      const double step = next > lo && next < hi ? next : 0.5 * (lo + hi);
      if (std::abs(step - t) <= kEps) break;
      t = step;
    }
    const double cx = std::copysign(std::cos(t), x), sy = std::copysign(std::sin(t), y);
    return std::atan2(sy, cx);
  }

  Axes3 axes_;
  double a_, b_, t0_, t1_;
};

}  // namespace

std::shared_ptr<const Curve> make_line(const Vec3& origin, const Vec3& direction, double t0, double t1) {
  return std::make_shared<Line>(origin, direction, t0, t1);
}

std::shared_ptr<const Curve> make_circle(const Axes3& axes, double radius, double t0, double t1) {
  return std::make_shared<Ellipse>(axes, radius, radius, t0, t1);
}

std::shared_ptr<const Curve> make_ellipse(const Axes3& axes, double major, double minor, double t0,
                                          double t1) {
  return std::make_shared<Ellipse>(axes, major, minor, t0, t1);
}

}  // namespace octet
