// SPDX-License-Identifier: BSD-3-Clause
// Planes, cylinders, cones, spheres and tori that are written as something else.
//
// Each form has a property that makes its axis a linear problem: normals of a cylinder are perpendicular to
// the axis, those of a cone make one angle with it, one focal surface of a torus is its spine circle.
#include "geom/recognise.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "geom/quadrics.h"
#include "geom/torus.h"

namespace octet {
namespace {

using Mat3 = Eigen::Matrix3d;

constexpr int kSteps = 4;           // samples in a span
constexpr std::size_t kLeast = 9;   // samples in a direction
constexpr std::size_t kMost = 400;  // more are not worth it
constexpr double kFlattest = 1e4;   // largest radius, of the size of the piece: beyond it the fit is noise
constexpr double kSameCurvature = 1e-3;  // relative, of a torus' own sections, before the exact test
constexpr double kSingular = 1e-7;       // |du| of the size: u is not to be had from the place

struct Sample {
  Vec3 p, n;
  SurfaceJet jet;
  bool regular = false;  ///< there is a normal
};

struct Samples {
  std::vector<double> u, v;
  std::vector<Sample> all;  ///< by u, then v
  Vec3 centre = Vec3::Zero();
  double size = 0.0;
};

std::vector<double> refined(std::span<const double> breaks) {
  const std::size_t spans = breaks.size() - 1;
  const std::size_t steps = std::max<std::size_t>(kSteps, (kLeast + spans - 2) / spans);
  std::vector<double> values;
  for (std::size_t i = 0; i < spans; ++i)
    for (std::size_t k = 0; k < steps; ++k)
      values.push_back(breaks[i] +
                       static_cast<double>(k) * (breaks[i + 1] - breaks[i]) / static_cast<double>(steps));
  values.push_back(breaks.back());
  return values;
}

std::optional<Samples> take(const std::function<SurfaceJet(const Vec2&, int)>& evaluate,
                            std::span<const double> u, std::span<const double> v) {
  Samples samples;
  samples.u = refined(u);
  samples.v = refined(v);
  if (samples.u.size() > kMost || samples.v.size() > kMost ||
      samples.u.size() * samples.v.size() > 16 * kMost)
    return std::nullopt;
  const double u_span = u.back() - u.front(), v_span = v.back() - v.front();
  Box3 box;
  for (const double a : samples.u)
    for (const double b : samples.v) {
      Sample s;
      s.jet = evaluate({a, b}, 2);
      s.p = s.jet.p;
      s.n = s.jet.du.cross(s.jet.dv);
      box.add(s.p);
      samples.all.push_back(s);
    }
  samples.centre = box.centre();
  samples.size = box.diagonal();
  for (Sample& s : samples.all) {
    const double area = s.n.norm();
    s.regular = area * u_span * v_span > 1e-6 * samples.size * samples.size;
    if (s.regular) s.n /= area;
  }
  return samples;
}

struct Eigen3 {
  Vec3 value;  ///< ascending
  Mat3 vector;
};

Eigen3 eigen(const Mat3& m) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// Right-handed frame about z; x as near to `wish` as it goes.
Axes3 frame(const Vec3& origin, const Vec3& z, const Vec3& wish) {
  Axes3 axes;
  axes.origin = origin;
  axes.z = z.normalized();
  Vec3 x = wish - wish.dot(axes.z) * axes.z;
  if (x.norm() < 1e-6 * wish.norm() || x.norm() == 0.0) x = axes.z.unitOrthogonal();
  axes.x = x.normalized();
  axes.y = axes.z.cross(axes.x);
  return axes;
}

struct Circle {
  Vec3 centre;
  double radius;
};

/// Least squares |q|^2 = 2 c.q + k in the plane through `middle` across `axis` (lengths scaled to one).
std::optional<Circle> fit_circle(const std::vector<Vec3>& points, const Vec3& middle, const Vec3& axis,
                                 double size) {
  const Axes3 plane = frame(middle, axis, Vec3::UnitX() + 0.3 * Vec3::UnitY());
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  for (const Vec3& p : points) {
    const Vec3 l = plane.to_local(p) / size;
    const Vec3 row(l.x(), l.y(), 1.0);
    a += row * row.transpose();
    b += row * (l.x() * l.x() + l.y() * l.y());
  }
  const Vec3 x = a.fullPivLu().solve(b);
  const Vec2 c = 0.5 * x.head<2>();
  const double r2 = x[2] + c.squaredNorm();
  if (!(r2 > 0.0) || r2 > kFlattest * kFlattest) return std::nullopt;
  return Circle{plane.to_world({c.x() * size, c.y() * size, 0.0}), std::sqrt(r2) * size};
}

using Candidate = std::function<std::shared_ptr<const Surface>(const Axes3&, double u0, double v0)>;
struct Fit {
  Axes3 axes;
  Candidate make;
  bool turns_u = false, turns_v = false;
};

std::vector<Vec3> points_of(const Samples& samples) {
  std::vector<Vec3> points;
  for (const Sample& s : samples.all) points.push_back(s.p);
  return points;
}

std::optional<Fit> fit_plane(const Samples& samples, const Vec3& along) {
  Mat3 spread = Mat3::Zero();
  Vec3 mean = Vec3::Zero();
  for (const Sample& s : samples.all) mean += s.p / static_cast<double>(samples.all.size());
  for (const Sample& s : samples.all) spread += (s.p - mean) * (s.p - mean).transpose();
  const Eigen3 e = eigen(spread);
  if (e.value[0] > 1e-10 * e.value[2]) return std::nullopt;
  return Fit{frame(mean, e.vector.col(0), along),
             [](const Axes3& axes, double, double) { return make_plane(axes); }};
}

std::optional<Fit> fit_cylinder(const Samples& samples, const Vec3& along) {
  Mat3 normals = Mat3::Zero();
  for (const Sample& s : samples.all)
    if (s.regular) normals += s.n * s.n.transpose();
  const Eigen3 e = eigen(normals);
  if (e.value[0] > 1e-8 * e.value[2] || e.value[1] < 1e-8 * e.value[2]) return std::nullopt;
  const Vec3 axis = e.vector.col(0);
  const auto circle = fit_circle(points_of(samples), samples.centre, axis, samples.size);
  if (!circle) return std::nullopt;
  const double radius = circle->radius;
  return Fit{frame(circle->centre, axis, along),
             [radius](const Axes3& axes, double u0, double) { return make_cylinder(axes, radius, u0); }, true,
             false};
}

std::optional<Fit> fit_cone(const Samples& samples, const Vec3& along) {
  Vec3 mean = Vec3::Zero();
  int count = 0;
  for (const Sample& s : samples.all)
    if (s.regular) {
      mean += s.n;
      ++count;
    }
  mean /= std::max(count, 1);
  Mat3 spread = Mat3::Zero(), normals = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (const Sample& s : samples.all) {
    if (!s.regular) continue;
    spread += (s.n - mean) * (s.n - mean).transpose();
    normals += s.n * s.n.transpose();
    right += s.n * s.n.dot(s.p - samples.centre);
  }
  const Eigen3 e = eigen(spread);
  if (e.value[0] > 1e-8 * e.value[2] || e.value[1] < 1e-8 * e.value[2]) return std::nullopt;
  const Vec3 apex = samples.centre + normals.fullPivLu().solve(right);
  Vec3 axis = e.vector.col(0);
  const double middle = (samples.centre - apex).dot(axis);
  if (middle < 0.0) axis = -axis;
  double angle = 0.0;
  for (const Sample& s : samples.all)
    if (s.regular) {
      const double z = (s.p - apex).dot(axis);
      angle += std::atan2((s.p - apex - z * axis).norm(), z) / count;
    }
  const double reach = std::abs(middle);
  const double radius = reach * std::tan(angle);
  if (!(angle > 1e-4 && angle < 0.5 * std::numbers::pi - 1e-4) || radius > kFlattest * samples.size ||
      !(radius > 1e-9 * samples.size))
    return std::nullopt;
  return Fit{
      frame(apex + reach * axis, axis, along),
      [angle, radius](const Axes3& axes, double u0, double) { return make_cone(axes, angle, radius, u0); },
      true, false};
}

/// Greatest cosine of the angles between the axis, either way, and where the samples are from the centre.
double nearness(const Samples& samples, const Vec3& centre, const Vec3& axis) {
  double most = 0.0;
  for (const Sample& s : samples.all) most = std::max(most, std::abs((s.p - centre).normalized().dot(axis)));
  return most;
}

/// The axis about which the source turns, if it does: along u or along v all samples are at one height.
std::optional<Vec3> axis_of_source(const Samples& samples) {
  constexpr double kSameHeight = 1e-6;  // of the size
  const std::size_t nu = samples.u.size(), nv = samples.v.size();
  const auto turned = [&](std::size_t count, std::size_t step, std::size_t lines,
                          std::size_t next) -> std::optional<Vec3> {
    const auto at = [&](std::size_t line, std::size_t k) -> const Vec3& {
      return samples.all[line * next + k * step].p;
    };
    const Vec3 &a = at(lines / 2, 0), &b = at(lines / 2, count / 3), &c = at(lines / 2, 2 * count / 3);
    Vec3 axis = (b - a).cross(c - b);
    if (!(axis.norm() > kSameHeight * samples.size * samples.size)) return std::nullopt;
    axis.normalize();
    for (std::size_t line = 0; line < lines; ++line)
      for (std::size_t k = 1; k < count; ++k)
        if (!(std::abs((at(line, k) - at(line, 0)).dot(axis)) <= kSameHeight * samples.size))
          return std::nullopt;
    return axis;
  };
  if (auto axis = turned(nu, nv, nv, 1)) return axis;
  return turned(nv, 1, nu, nv);
}

/// As seen from the centre, half the longest diagonal between neighbouring samples: no place of the source is
/// much farther from all of them.
double gap_between(const Samples& samples, const Vec3& centre) {
  const std::size_t nu = samples.u.size(), nv = samples.v.size();
  const auto at = [&](std::size_t a, std::size_t b) -> Vec3 {
    return (samples.all[a * nv + b].p - centre).normalized();
  };
  double least = 1.0;
  for (std::size_t a = 0; a + 1 < nu; ++a)
    for (std::size_t b = 0; b + 1 < nv; ++b)
      least = std::min({least, at(a, b).dot(at(a + 1, b + 1)), at(a + 1, b).dot(at(a, b + 1))});
  return 0.5 * std::acos(std::clamp(least, -1.0, 1.0));
}

/// An axis whose poles are clear of the source: about a pole on it u cannot follow. `asked` where that will
/// do, else the clearest of the source's own and some others; nothing where the source is all over the
/// sphere.
std::optional<Vec3> clear_axis(const Samples& samples, const Vec3& centre, const Vec3& asked) {
  constexpr double kClear = 0.95, kNeeded = 0.99;  // cosines of 18 and 8 degrees
  constexpr double kReserve = 1.2;
  const double between = std::cos(kReserve * gap_between(samples, centre));
  Vec3 best = asked.normalized();
  double least = nearness(samples, centre, best);
  if (least <= std::min(kClear, between)) return best;
  if (least > between) least = 1.0;
  // About the source's own axis its places are as far from the poles as its samples are.
  const std::optional<Vec3> own = axis_of_source(samples);
  if (const double near = own ? nearness(samples, centre, *own) : 1.0; near < least) {
    least = near;
    best = *own;
  }
  for (int k = 0; k < 27; ++k) {
    const Vec3 axis(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1);
    if (axis.isZero()) continue;
    const double near = nearness(samples, centre, axis.normalized());
    if (near >= least || near > between) continue;
    least = near;
    best = axis.normalized();
  }
  return least <= kNeeded ? std::optional<Vec3>(best) : std::nullopt;
}

std::optional<Fit> fit_sphere(const Samples& samples, const Vec3& along) {
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const Sample& s : samples.all) {
    const Vec3 l = (s.p - samples.centre) / samples.size;
    const Eigen::Vector4d row(l.x(), l.y(), l.z(), 1.0);
    a += row * row.transpose();
    b += row * l.squaredNorm();
  }
  const Eigen::Vector4d x = a.fullPivLu().solve(b);
  const Vec3 c = 0.5 * x.head<3>();
  const double r2 = x[3] + c.squaredNorm();
  if (!(r2 > 0.0) || r2 > kFlattest * kFlattest) return std::nullopt;
  const double radius = std::sqrt(r2) * samples.size;
  // The poles stay where the source has them, if it has: u is then one value along a border.
  const Vec3 centre = samples.centre + samples.size * c;
  std::optional<Vec3> pole;
  for (const Sample& s : samples.all)
    if (!s.regular) pole = s.p - centre;
  if (!pole) pole = clear_axis(samples, centre, along);
  if (!pole) return std::nullopt;
  return Fit{frame(centre, *pole, Vec3::UnitX() + 0.3 * Vec3::UnitY()),
             [radius](const Axes3& axes, double u0, double) { return make_sphere(axes, radius, u0); }, true,
             false};
}

/// Principal curvatures, ascending, towards n.
Vec2 curvatures(const Sample& s) {
  const SurfaceJet& j = s.jet;
  const double e = j.du.squaredNorm(), f = j.du.dot(j.dv), g = j.dv.squaredNorm();
  const double l = j.duu.dot(s.n), m = j.duv.dot(s.n), k = j.dvv.dot(s.n);
  const double det = e * g - f * f;
  const double mean = 0.5 * (l * g - 2.0 * m * f + k * e) / det, gauss = (l * k - m * m) / det;
  const double w = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean - w, mean + w};
}

std::optional<Fit> fit_torus(const Samples& samples, const Vec3&) {
  for (const int which : {0, 1}) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo, sum = 0.0;
    int count = 0;
    for (const Sample& s : samples.all) {
      if (!s.regular) continue;
      const double k = curvatures(s)[which];
      lo = std::min(lo, k);
      hi = std::max(hi, k);
      sum += k;
      ++count;
    }
    if (count == 0 || !(hi - lo <= kSameCurvature * std::abs(sum / count))) continue;
    const double minor = count / sum;  // signed, along the normal
    if (std::abs(minor) > kFlattest * samples.size) continue;
    std::vector<Vec3> spine;
    Vec3 mean = Vec3::Zero();
    for (const Sample& s : samples.all)
      if (s.regular) {
        spine.push_back(s.p + minor * s.n);
        mean += spine.back() / count;
      }
    Mat3 spread = Mat3::Zero();
    for (const Vec3& p : spine) spread += (p - mean) * (p - mean).transpose();
    const Eigen3 e = eigen(spread);
    if (e.value[0] > 1e-6 * e.value[2] || e.value[1] < 1e-8 * e.value[2]) continue;
    const auto circle = fit_circle(spine, mean, e.vector.col(0), samples.size);
    if (!circle) continue;
    const double radius = std::abs(minor);
    // The sheets of a spindle part with the root of the difference: rounding must not make one of a horn.
    const double major = std::abs(circle->radius - radius) <= 1e-9 * radius ? radius : circle->radius;
    return Fit{frame(circle->centre, e.vector.col(0), samples.centre - circle->centre),
               [major, radius](const Axes3& axes, double u0, double v0) {
                 return make_torus(axes, major, radius, u0, v0);
               },
               true, true};
  }
  return std::nullopt;
}

double nearest_turn(double angle, double expected) {
  return angle - kTwoPi * std::round((angle - expected) / kTwoPi);
}

/// Whether all samples lie on the surface; their (u,v) there, not yet continuous.
bool agrees(const Samples& samples, const Surface& surface, double tolerance, std::vector<Vec2>& uv) {
  uv.clear();
  for (const Sample& s : samples.all) {
    const SurfaceFoot foot = surface.project(s.p, Vec2::Zero());
    if (!((foot.point - s.p).norm() <= tolerance)) return false;
    uv.push_back(foot.uv);
  }
  return true;
}

/// Makes angles follow their neighbours in the grid. At a pole u has no value of its own: it is taken from a
/// neighbour, first in the same row, so that along the pole it runs as it does beside it.
class Unwrapper {
 public:
  Unwrapper(const Samples& samples, const Fit& fit, const Surface& surface, std::vector<Vec2>& uv)
      : fit_(fit), nu_(samples.u.size()), nv_(samples.v.size()), uv_(uv) {
    for (const Vec2& x : uv)
      singular_.push_back(fit.turns_u && surface.evaluate(x, 1).du.norm() <= kSingular * samples.size);
  }

  void run() {
    // From a column near the middle, along u in each row.
    const std::size_t middle = nu_ / 2;
    follow_line(middle * nv_, 1, nv_, first_regular(middle * nv_, 1, nv_));
    for (std::size_t b = 0; b < nv_; ++b) follow_line(b, nv_, nu_, middle);
    for (std::size_t i = 0; i < uv_.size(); ++i)
      if (singular_[i]) borrow(i);
  }

 private:
  [[nodiscard]] std::size_t first_regular(std::size_t begin, std::size_t step, std::size_t count) const {
    for (std::size_t k = 0; k < count; ++k)
      if (!singular_[begin + k * step]) return k;
    return 0;
  }

  void follow(std::size_t i, std::size_t& from) {
    if (fit_.turns_v) uv_[i].y() = nearest_turn(uv_[i].y(), uv_[from].y());
    if (singular_[i]) return;
    if (fit_.turns_u) uv_[i].x() = nearest_turn(uv_[i].x(), uv_[from].x());
    from = i;
  }

  /// Outwards from item `start` of a row or column.
  void follow_line(std::size_t begin, std::size_t step, std::size_t count, std::size_t start) {
    std::size_t from = begin + start * step;
    for (std::size_t k = start + 1; k < count; ++k) follow(begin + k * step, from);
    from = begin + start * step;
    for (std::size_t k = start; k-- > 0;) follow(begin + k * step, from);
  }

  void borrow(std::size_t i) {
    const std::size_t a = i / nv_, b = i % nv_;
    const std::size_t beside_v = b == 0 ? i + 1 : i - 1, beside_u = a == 0 ? i + nv_ : i - nv_;
    uv_[i].x() = uv_[singular_[beside_v] ? beside_u : beside_v].x();
  }

  const Fit& fit_;
  std::size_t nu_, nv_;
  std::vector<Vec2>& uv_;
  std::vector<bool> singular_;
};

/// Start of a period with [lo, hi] in its middle.
double period_start(double lo, double hi) { return lo - 0.5 * std::max(0.0, kTwoPi - (hi - lo)); }

std::unique_ptr<const CanonicalForm> accept(const Samples& samples, Fit fit, double tolerance) {
  auto surface = fit.make(fit.axes, 0.0, 0.0);
  std::vector<Vec2> uv;
  if (!agrees(samples, *surface, tolerance, uv)) return nullptr;
  const auto regular =
      std::find_if(samples.all.begin(), samples.all.end(), [](const Sample& s) { return s.regular; });
  const auto index = static_cast<std::size_t>(regular - samples.all.begin());
  if (surface->normal(uv[index]).dot(regular->n) < 0.0) {
    fit.axes.y = -fit.axes.y;
    surface = fit.make(fit.axes, 0.0, 0.0);
    if (!agrees(samples, *surface, tolerance, uv)) return nullptr;
  }
  Unwrapper(samples, fit, *surface, uv).run();
  Vec2 lo = uv.front(), hi = uv.front();
  for (const Vec2& x : uv) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  }
  constexpr double kWhole = kTwoPi * (1.0 + 1e-6);
  if ((fit.turns_u && hi.x() - lo.x() > kWhole) || (fit.turns_v && hi.y() - lo.y() > kWhole)) return nullptr;
  surface = fit.make(fit.axes, period_start(lo.x(), hi.x()), period_start(lo.y(), hi.y()));
  return std::make_unique<CanonicalForm>(std::move(surface), samples.u, samples.v, std::move(uv),
                                         kSingular * samples.size);
}

}  // namespace

Vec2 CanonicalForm::map(const Vec3& point, const Vec2& source_uv) const {
  const auto place = [](const std::vector<double>& grid, double x, double& share) {
    const auto next = std::upper_bound(grid.begin() + 1, grid.end() - 1, x);
    const auto i = static_cast<std::size_t>(next - grid.begin()) - 1;
    share = std::clamp((x - grid[i]) / (grid[i + 1] - grid[i]), 0.0, 1.0);
    return i;
  };
  double s = 0.0, t = 0.0;
  const std::size_t a = place(u_, source_uv.x(), s), b = place(v_, source_uv.y(), t), nv = v_.size();
  const Vec2* const at = table_.data() + a * nv + b;
  const Vec2 expected =
      (1.0 - s) * ((1.0 - t) * at[0] + t * at[1]) + s * ((1.0 - t) * at[nv] + t * at[nv + 1]);
  Vec2 uv = surface_->project(point, expected).uv;
  const std::string_view kind = surface_->kind();
  if (kind == "plane") return uv;
  uv.x() = nearest_turn(uv.x(), expected.x());
  if (kind == "torus") uv.y() = nearest_turn(uv.y(), expected.y());
  const SurfaceJet jet = surface_->evaluate(uv, 1);
  if (jet.du.norm() <= singular_) uv.x() = expected.x();
  return uv;
}

std::unique_ptr<const CanonicalForm> recognise(const std::function<SurfaceJet(const Vec2&, int)>& evaluate,
                                               std::span<const double> u, std::span<const double> v,
                                               double tolerance) {
  const auto samples = take(evaluate, u, v);
  if (!samples || !(samples->size > 0.0)) return nullptr;
  const auto regular =
      std::find_if(samples->all.begin(), samples->all.end(), [](const Sample& s) { return s.regular; });
  if (regular == samples->all.end()) return nullptr;
  using Fitter = std::optional<Fit> (*)(const Samples&, const Vec3&);
  for (const Fitter fitter :
       {Fitter(fit_plane), Fitter(fit_cylinder), Fitter(fit_cone), Fitter(fit_sphere), Fitter(fit_torus)})
    if (auto fit = fitter(*samples, regular->jet.du))
      if (auto form = accept(*samples, std::move(*fit), tolerance)) return form;
  return nullptr;
}

}  // namespace octet
