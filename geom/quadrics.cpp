// SPDX-License-Identifier: BSD-3-Clause
// Plane, cylinder, cone and sphere in closed form.
#include "geom/quadrics.h"

#include <algorithm>
#include <array>

#include "base/constants.h"

namespace octet {
namespace {

/// Rounding of local coordinates: what a computed distance may be wrong by.
double rounding(const Axes3& axes, const Vec3& p, const Vec3& q, double size) {
  return 16.0 * kEps * (axes.origin.norm() + p.norm() + q.norm() + size);
}

/// f(t) = a t^2 + 2 b t + c.
struct Quadratic {
  double a = 0.0, b = 0.0, c = 0.0;
};

struct QuadraticRoots {
  int count = 0;
  std::array<double, 2> t{};
  bool tangent = false;
};

/// Roots of f, whose values are wrong by up to `noise`. `at` gives f about another origin, so that
/// the discriminant is taken where the line is nearest to tangency and cancels nothing.
template <class About>
QuadraticRoots solve(const About& about, double noise) {
  double origin = 0.5;
  Quadratic f = about(origin);
  if (f.a != 0.0) {
    const double vertex = std::clamp(origin - f.b / f.a, -1.0, 2.0);
    origin = vertex;
    f = about(origin);
  }
  QuadraticRoots roots;
  const double disc = f.b * f.b - f.a * f.c;
  const double fuzz = std::abs(f.a) * noise;
  if (disc < -fuzz) return roots;
  if (disc <= fuzz && f.a != 0.0) {
    roots = {1, {origin - f.b / f.a, 0.0}, true};
    return roots;
  }
  const double w = std::sqrt(std::max(disc, 0.0));
  const double s = -(f.b + std::copysign(w, f.b));
  if (f.a != 0.0) roots.t[roots.count++] = origin + s / f.a;
  if (s != 0.0) roots.t[roots.count++] = origin + f.c / s;
  if (roots.count == 2 && roots.t[1] < roots.t[0]) std::swap(roots.t[0], roots.t[1]);
  return roots;
}

class Plane final : public Surface {
 public:
  explicit Plane(const Axes3& axes) : axes_(axes), normal_(axes.z * axes.handedness()) {}

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    SurfaceJet jet;
    jet.p = axes_.origin + uv.x() * axes_.x + uv.y() * axes_.y;
    if (derivatives > 0) {
      jet.du = axes_.x;
      jet.dv = axes_.y;
    }
    return jet;
  }

  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    const double hp = (p - axes_.origin).dot(axes_.z), hq = (q - axes_.origin).dot(axes_.z);
    const double noise = rounding(axes_, p, q, 0.0);
    if (std::abs(hp) <= noise && std::abs(hq) <= noise) {
      roots.push_back({0.0, uv_of(p), false, true});
      roots.push_back({1.0, uv_of(q), false, true});
      return;
    }
    if ((hp > 0.0) == (hq > 0.0) && hp != 0.0 && hq != 0.0) return;
    const double t = hp / (hp - hq);
    roots.push_back({t, uv_of(p + t * (q - p)), false, false});
  }

  SurfaceFoot project(const Vec3& p, const Vec2&) const override {
    const Vec2 uv = uv_of(p);
    return {uv, axes_.origin + uv.x() * axes_.x + uv.y() * axes_.y, true};
  }

  Vec3 normal(const Vec2&) const override { return normal_; }
  const char* kind() const override { return "plane"; }

 private:
  [[nodiscard]] Vec2 uv_of(const Vec3& p) const {
    const Vec3 d = p - axes_.origin;
    return {d.dot(axes_.x), d.dot(axes_.y)};
  }
  Axes3 axes_;
  Vec3 normal_;
};

/// What cylinder, cone and sphere share: a polar angle about z and a quadratic equation.
class RoundSurface : public Surface {
 public:
  RoundSurface(const Axes3& axes, double radius, double u0)
      : axes_(axes), radius_(radius), u0_(u0), hand_(axes.handedness()) {}

  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    const Vec3 a = axes_.to_local(p), d = axes_.direction_to_local(q - p);
    const auto about = [&](double t) { return quadratic(a + t * d, d); };
    const double wrong = rounding(axes_, p, q, radius_);
    const double noise = value_noise(wrong, a + 0.5 * d);
    const auto vanishes = [&](double t) {
      return std::abs(about(t).c) <= 4.0 * value_noise(wrong, a + t * d);
    };
    if (vanishes(0.5) && vanishes(0.0) && vanishes(1.0)) {
      roots.push_back({0.0, uv_of(a), false, true});
      roots.push_back({1.0, uv_of(a + d), false, true});
      return;
    }
    const QuadraticRoots found = solve(about, noise);
    for (int i = 0; i < found.count; ++i) {
      const double t = found.t[i];
      if (t >= 0.0 && t <= 1.0) roots.push_back({t, uv_of(a + t * d), found.tangent, false});
    }
  }

 protected:
  /// f(l + t d) for the local point l.
  [[nodiscard]] virtual Quadratic quadratic(const Vec3& l, const Vec3& d) const = 0;
  [[nodiscard]] virtual Vec2 uv_of(const Vec3& local) const = 0;
  /// What f may be wrong by where distances are wrong by `rounding`.
  [[nodiscard]] virtual double value_noise(double rounding, const Vec3& local) const = 0;

  [[nodiscard]] double angle(double x, double y) const { return wrap_angle(std::atan2(y, x), u0_); }
  [[nodiscard]] double angle_near(double x, double y, double seed) const {
    if (x * x + y * y <= kEps * kEps * radius_ * radius_) return wrap_angle_near(seed, u0_, seed);
    return wrap_angle_near(std::atan2(y, x), u0_, seed);
  }
  /// Radial and tangential unit vectors at angle u.
  void radial(double u, Vec3& e, Vec3& f) const {
    const double c = std::cos(u), s = std::sin(u);
    e = c * axes_.x + s * axes_.y;
    f = c * axes_.y - s * axes_.x;
  }

  Axes3 axes_;
  double radius_, u0_, hand_;
};

class Cylinder final : public RoundSurface {
 public:
  using RoundSurface::RoundSurface;

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    SurfaceJet jet;
    jet.p = axes_.origin + radius_ * e + uv.y() * axes_.z;
    if (derivatives > 0) {
      jet.du = radius_ * f;
      jet.dv = axes_.z;
    }
    if (derivatives > 1) jet.duu = -radius_ * e;
    return jet;
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    const Vec3 l = axes_.to_local(p);
    const Vec2 uv(angle_near(l.x(), l.y(), seed.x()), l.z());
    return {uv, evaluate(uv, 0).p, true};
  }

  Vec3 normal(const Vec2& uv) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    return hand_ * e;
  }
  const char* kind() const override { return "cylinder"; }

 private:
  Quadratic quadratic(const Vec3& l, const Vec3& d) const override {
    const double rho = l.head<2>().norm();
    return {d.x() * d.x() + d.y() * d.y(), l.x() * d.x() + l.y() * d.y(), (rho - radius_) * (rho + radius_)};
  }
  Vec2 uv_of(const Vec3& l) const override { return {angle(l.x(), l.y()), l.z()}; }
  double value_noise(double rounding, const Vec3&) const override { return 2.0 * radius_ * rounding; }
};

class Cone final : public RoundSurface {
 public:
  Cone(const Axes3& axes, double semi_angle, double radius, double u0)
      : RoundSurface(axes, radius, u0), sin_(std::sin(semi_angle)), cos_(std::cos(semi_angle)) {}

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    const double r = radius_at(uv.y());
    SurfaceJet jet;
    jet.p = axes_.origin + r * e + uv.y() * cos_ * axes_.z;
    if (derivatives > 0) {
      jet.du = r * f;
      jet.dv = sin_ * e + cos_ * axes_.z;
    }
    if (derivatives > 1) {
      jet.duu = -r * e;
      jet.duv = sin_ * f;
    }
    return jet;
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    const Vec3 l = axes_.to_local(p);
    // The nappe is the seed's: a foot that would pass the apex stays there.
    const double side = radius_at(seed.y()) < 0.0 ? -1.0 : 1.0;
    const double rho = side * l.head<2>().norm();
    double v = (rho - radius_) * sin_ + l.z() * cos_;
    if (side * radius_at(v) < 0.0) v = -radius_ / sin_;
    const Vec2 uv(angle_near(side * l.x(), side * l.y(), seed.x()), v);
    return {uv, evaluate(uv, 0).p, true};
  }

  Vec3 normal(const Vec2& uv) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    const double side = radius_at(uv.y()) < -1e-12 * radius_ ? -1.0 : 1.0;
    return hand_ * side * (cos_ * e - sin_ * axes_.z);
  }
  const char* kind() const override { return "cone"; }

 private:
  [[nodiscard]] double radius_at(double v) const { return radius_ + v * sin_; }

  // cos^2 (x^2 + y^2) - (radius cos + z sin)^2, that is z measured from the apex.
  Quadratic quadratic(const Vec3& l, const Vec3& d) const override {
    const double rho = cos_ * l.head<2>().norm();
    const double z = radius_ * cos_ + l.z() * sin_, dz = d.z() * sin_;
    const double cc = cos_ * cos_;
    return {cc * (d.x() * d.x() + d.y() * d.y()) - dz * dz, cc * (l.x() * d.x() + l.y() * d.y()) - z * dz,
            (rho - z) * (rho + z)};
  }
  Vec2 uv_of(const Vec3& l) const override {
    const double v = l.z() / cos_;
    return radius_at(v) < 0.0 ? Vec2(angle(-l.x(), -l.y()), v) : Vec2(angle(l.x(), l.y()), v);
  }
  double value_noise(double rounding, const Vec3& l) const override {
    const double z = std::abs(radius_ * cos_ + l.z() * sin_);
    return (2.0 * z + rounding) * rounding;
  }
  double sin_, cos_;
};

class Sphere final : public RoundSurface {
 public:
  using RoundSurface::RoundSurface;

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    const double c = radius_ * std::cos(uv.y()), s = radius_ * std::sin(uv.y());
    SurfaceJet jet;
    jet.p = axes_.origin + c * e + s * axes_.z;
    if (derivatives > 0) {
      jet.du = c * f;
      jet.dv = c * axes_.z - s * e;
    }
    if (derivatives > 1) {
      jet.duu = -c * e;
      jet.duv = -s * f;
      jet.dvv = -c * e - s * axes_.z;
    }
    return jet;
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    const Vec3 l = axes_.to_local(p);
    const double rho = l.head<2>().norm();
    const double length = l.norm();
    if (length <= kEps * radius_) return {seed, evaluate(seed, 0).p, true};
    const Vec2 uv(angle_near(l.x(), l.y(), seed.x()), std::atan2(l.z(), rho));
    return {uv, axes_.to_world(l * (radius_ / length)), true};
  }

  Vec3 normal(const Vec2& uv) const override {
    Vec3 e, f;
    radial(uv.x(), e, f);
    return hand_ * (std::cos(uv.y()) * e + std::sin(uv.y()) * axes_.z);
  }
  const char* kind() const override { return "sphere"; }

 private:
  Quadratic quadratic(const Vec3& l, const Vec3& d) const override {
    const double r = l.norm();
    return {d.squaredNorm(), l.dot(d), (r - radius_) * (r + radius_)};
  }
  Vec2 uv_of(const Vec3& l) const override {
    return {angle(l.x(), l.y()), std::atan2(l.z(), l.head<2>().norm())};
  }
  double value_noise(double rounding, const Vec3&) const override { return 2.0 * radius_ * rounding; }
};

}  // namespace

std::shared_ptr<const Surface> make_plane(const Axes3& axes) { return std::make_shared<Plane>(axes); }

std::shared_ptr<const Surface> make_cylinder(const Axes3& axes, double radius, double u0) {
  return std::make_shared<Cylinder>(axes, radius, u0);
}

std::shared_ptr<const Surface> make_cone(const Axes3& axes, double semi_angle, double radius, double u0) {
  return std::make_shared<Cone>(axes, semi_angle, radius, u0);
}

std::shared_ptr<const Surface> make_sphere(const Axes3& axes, double radius, double u0) {
  return std::make_shared<Sphere>(axes, radius, u0);
}

}  // namespace octet
