// SPDX-License-Identifier: BSD-3-Clause
// The torus in closed form: the quartic's roots are parted by the roots of its derivatives.
#include "geom/torus.h"

#include <algorithm>
#include <array>

#include "base/constants.h"

namespace octet {
namespace {

/// A polynomial of degree N on [0,1] in Bernstein form: its coefficients bound it.
template <int N>
using Bernstein = std::array<double, N + 1>;

template <int N>
bool one_sign(const Bernstein<N>& b) {
  const auto [lo, hi] = std::minmax_element(b.begin(), b.end());
  return *lo > 0.0 || *hi < 0.0;
}

template <int N>
Bernstein<N - 1> derivative(const Bernstein<N>& b) {
  Bernstein<N - 1> d;
  for (int i = 0; i < N; ++i) d[i] = N * (b[i + 1] - b[i]);
  return d;
}

template <int N>
double value(Bernstein<N> b, double t) {
  for (int level = N; level > 0; --level)
    for (int i = 0; i < level; ++i) b[i] = (1.0 - t) * b[i] + t * b[i + 1];
  return b[0];
}

/// The root of f in [lo, hi], where f is monotone and changes sign: bisection with secant steps (Illinois).
template <class F>
double bracketed_root(const F& f, double lo, double hi, double f_lo, double f_hi) {
  for (int i = 0; i < 100 && hi - lo > 2.0 * kEps * (std::abs(lo) + std::abs(hi)); ++i) {
    double t = lo + (hi - lo) * (f_lo / (f_lo - f_hi));
    if (i % 4 == 3 || !(t > lo && t < hi)) t = 0.5 * (lo + hi);
    if (t <= lo || t >= hi) break;
    const double ft = f(t);
    if (ft == 0.0) return t;
    if ((ft > 0.0) == (f_lo > 0.0)) {
      lo = t;
      f_lo = ft;
      f_hi *= 0.5;
    } else {
      hi = t;
      f_hi = ft;
      f_lo *= 0.5;
    }
  }
  return 0.5 * (lo + hi);
}

/// At most N + 2 increasing parameters: 0, the roots of a polynomial of degree N in (0,1), 1.
template <int N>
struct Partition {
  std::array<double, N + 2> t{};
  int count = 0;
  void add(double x) { t[count++] = x; }
};

/// Parts [0,1] at the roots of b, found between the roots of its derivative.
template <int N>
Partition<N> part_at_roots(const Bernstein<N>& b) {
  Partition<N> parts;
  parts.add(0.0);
  if constexpr (N == 1) {
    const double t = b[0] / (b[0] - b[1]);
    if (t > 0.0 && t < 1.0) parts.add(t);
  } else {
    if (!one_sign<N>(b)) {
      const Partition<N - 1> monotone = part_at_roots<N - 1>(derivative<N>(b));
      double before = b[0];
      for (int i = 1; i < monotone.count; ++i) {
        const double lo = monotone.t[i - 1], hi = monotone.t[i];
        const double after = value<N>(b, hi);
        if ((before > 0.0) != (after > 0.0))
          parts.add(bracketed_root([&](double t) { return value<N>(b, t); }, lo, hi, before, after));
        before = after;
      }
    }
  }
  parts.add(1.0);
  return parts;
}

/// Where a segment runs, in the torus' frame.
struct LocalSegment {
  Vec3 p, d;
  [[nodiscard]] Vec3 at(double t) const { return p + t * d; }
};

class Torus final : public Surface {
 public:
  Torus(const Axes3& axes, double major, double minor, double u0, double v0)
      : axes_(axes), major_(major), minor_(minor), u0_(u0), v0_(v0), hand_(axes.handedness()) {}

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    const Vec3 e = std::cos(uv.x()) * axes_.x + std::sin(uv.x()) * axes_.y;
    const Vec3 f = std::cos(uv.x()) * axes_.y - std::sin(uv.x()) * axes_.x;
    const double c = minor_ * std::cos(uv.y()), s = minor_ * std::sin(uv.y());
    SurfaceJet jet;
    jet.p = axes_.origin + (major_ + c) * e + s * axes_.z;
    if (derivatives > 0) {
      jet.du = (major_ + c) * f;
      jet.dv = c * axes_.z - s * e;
    }
    if (derivatives > 1) {
      jet.duu = -(major_ + c) * e;
      jet.duv = -s * f;
      jet.dvv = -c * e - s * axes_.z;
    }
    return jet;
  }

  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    const LocalSegment segment{axes_.to_local(p), axes_.direction_to_local(q - p)};
    const Bernstein<4> f = quartic(segment);
    const double size = major_ + minor_;
    const double rounding = 16.0 * kEps * (axes_.origin.norm() + p.norm() + q.norm() + size);
    const auto [lo, hi] = std::minmax_element(f.begin(), f.end());
    // The quartic is about 8 major^2 minor times the distance; its own rounding is that of size^4.
    const double slack = 64.0 * kEps * std::pow(size + segment.p.norm() + segment.d.norm(), 4) +
                         8.0 * size * size * size * rounding;
    if (*lo > slack || *hi < -slack) return;
    add_roots(segment, part_at_roots<3>(derivative<4>(f)), rounding * size, roots);
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    const Vec3 l = axes_.to_local(p);
    const double rho = l.head<2>().norm();
    // A spindle torus has an outer and an inner sheet over each rho: the foot stays on the seed's.
    const double side = major_ + minor_ * std::cos(seed.y()) < 0.0 ? -1.0 : 1.0;
    const double u = rho <= kEps * major_
                         ? wrap_angle_near(seed.x(), u0_, seed.x())
                         : wrap_angle_near(std::atan2(side * l.y(), side * l.x()), u0_, seed.x());
    const double across = side * rho - major_;
    const bool on_spine = Vec2(across, l.z()).norm() <= kEps * major_;
    double turn = std::atan2(l.z(), across);
    // A foot that would pass the point where the sheets meet stays there.
    if (minor_ > major_ && side * (major_ + minor_ * std::cos(turn)) < 0.0)
      turn = std::copysign(std::acos(-major_ / minor_), turn);
    const Vec2 uv(u, on_spine ? seed.y() : wrap_angle_near(turn, v0_, seed.y()));
    return {uv, evaluate(uv, 0).p, true};
  }

  Vec3 normal(const Vec2& uv) const override {
    const Vec3 e = std::cos(uv.x()) * axes_.x + std::sin(uv.x()) * axes_.y;
    const double c = std::cos(uv.y());
    const double side = major_ + minor_ * c < 0.0 ? -1.0 : 1.0;
    return hand_ * side * (c * e + std::sin(uv.y()) * axes_.z);
  }
  const char* kind() const override { return "torus"; }

 private:
  /// (|x|^2 + major^2 - minor^2)^2 - 4 major^2 (x^2 + y^2) along the segment.
  [[nodiscard]] Bernstein<4> quartic(const LocalSegment& s) const {
    const Vec3 q = s.at(1.0);
    const double k = (major_ - minor_) * (major_ + minor_);
    const Bernstein<2> g{s.p.squaredNorm() + k, s.p.dot(q) + k, q.squaredNorm() + k};
    const double m = 4.0 * major_ * major_;
    const Bernstein<2> h{m * s.p.head<2>().squaredNorm(), m * s.p.head<2>().dot(q.head<2>()),
                         m * q.head<2>().squaredNorm()};
    return {g[0] * g[0] - h[0], g[0] * g[1] - 0.5 * (h[0] + h[1]),
            (g[0] * g[2] + 2.0 * g[1] * g[1]) / 3.0 - (h[0] + 4.0 * h[1] + h[2]) / 6.0,
            g[1] * g[2] - 0.5 * (h[1] + h[2]), g[2] * g[2] - h[2]};
  }

  /// The same sign as the quartic, without its cancellation: distance to the near sheet times that to the
  /// far one.
  [[nodiscard]] double level(const Vec3& l) const { return from_sheet(l, 1.0) * from_sheet(l, -1.0); }

  /// Signed distance to one sheet: the outer one (1), or the inner one of a spindle torus (-1).
  [[nodiscard]] double from_sheet(const Vec3& l, double side) const {
    return Vec2(l.head<2>().norm() - side * major_, l.z()).norm() - minor_;
  }

  /// The sheets of a spindle torus that a stretch crosses within which both are as near as rounding: those of
  /// a fillet's corner that is all but a sphere. Returns whether it crosses any.
  bool add_sheets(const LocalSegment& s, double lo, double hi, std::vector<SurfaceRoot>& roots) const {
    const std::size_t first = roots.size();
    for (const double side : {1.0, -1.0}) {
      const auto f = [&](double t) { return from_sheet(s.at(t), side); };
      const double f_lo = f(lo), f_hi = f(hi);
      if ((f_lo > 0.0) != (f_hi > 0.0)) add(s, bracketed_root(f, lo, hi, f_lo, f_hi), false, side, roots);
    }
    if (roots.size() == first + 2 && roots[first + 1].t < roots[first].t)
      std::swap(roots[first], roots[first + 1]);
    return roots.size() > first;
  }

  /// Between the quartic's extrema f is monotone: a sign change is a root, an extremum at zero a touch.
  /// Extrema joined by a stretch of zeros are one root (fourth order contact with the top circle).
  void add_roots(const LocalSegment& s, const Partition<3>& parts, double noise,
                 std::vector<SurfaceRoot>& roots) const {
    const auto f = [&](double t) { return level(s.at(t)); };
    std::array<double, 5> fs{};
    for (int i = 0; i < parts.count; ++i) fs[i] = f(parts.t[i]);
    const auto zero = [&](int i) { return std::abs(fs[i]) <= noise; };
    double before = 0.0;  // sign of f before the present cluster; 0: unknown, the segment starts in it
    for (int i = 0; i < parts.count; ++i) {
      if (!zero(i)) {
        if (i > 0 && !zero(i - 1) && (fs[i - 1] > 0.0) != (fs[i] > 0.0))
          add(s, bracketed_root(f, parts.t[i - 1], parts.t[i], fs[i - 1], fs[i]), false, roots);
        before = fs[i];
        continue;
      }
      int last = i;
      while (last + 1 < parts.count && zero(last + 1) &&
             std::abs(f(0.5 * (parts.t[last] + parts.t[last + 1]))) <= noise)
        ++last;
      const bool at_end = i == 0 || last + 1 == parts.count;
      if (minor_ > major_ && !at_end && add_sheets(s, parts.t[i - 1], parts.t[last + 1], roots)) {
        i = last;
        continue;
      }
      const double after = last + 1 < parts.count ? fs[last + 1] : 0.0;
      const bool crosses = before * after < 0.0 || (at_end && last == i);
      const double t = i == 0 ? 0.0 : last + 1 == parts.count ? 1.0 : 0.5 * (parts.t[i] + parts.t[last]);
      add(s, t, !crosses, roots);
      i = last;
    }
  }

  void add(const LocalSegment& s, double t, bool tangent, std::vector<SurfaceRoot>& roots) const {
    const Vec3 l = s.at(t);
    const bool is_inner = std::abs(from_sheet(l, -1.0)) < std::abs(from_sheet(l, 1.0));
    add(s, t, tangent, is_inner ? -1.0 : 1.0, roots);
  }

  void add(const LocalSegment& s, double t, bool tangent, double side,
           std::vector<SurfaceRoot>& roots) const {
    const Vec3 l = s.at(t);
    const double rho = l.head<2>().norm();
    const double u = wrap_angle(std::atan2(side * l.y(), side * l.x()), u0_);
    const double v = wrap_angle(std::atan2(l.z(), side * rho - major_), v0_);
    roots.push_back({t, Vec2(u, v), tangent, false});
  }

  Axes3 axes_;
  double major_, minor_, u0_, v0_, hand_;
};

}  // namespace

std::shared_ptr<const Surface> make_torus(const Axes3& axes, double major, double minor, double u0,
                                          double v0) {
  return std::make_shared<Torus>(axes, major, minor, u0, v0);
}

}  // namespace octet
