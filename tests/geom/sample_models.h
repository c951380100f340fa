// SPDX-License-Identifier: BSD-3-Clause
// Analytic models with the formula of their inside, and random points, for the tests of geom.
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "geom/analytic.h"

namespace octet::test {

/// Uniform doubles with the same values on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double operator()(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vec(const Vec3& lo, const Vec3& hi) {
    const double x = (*this)(lo.x(), hi.x());
    const double y = (*this)(lo.y(), hi.y());
    const double z = (*this)(lo.z(), hi.z());
    return {x, y, z};
  }
  Vec3 in(const Box3& box) { return vec(box.lo, box.hi); }
  Vec3 direction() {
    Vec3 d;
    do d = vec(Vec3::Constant(-1), Vec3::Constant(1));
    while (d.norm() > 1.0 || d.norm() < 0.1);
    return d.normalized();
  }

 private:
  std::mt19937 engine_;
};

inline Frame tilted_frame() {
  Frame frame;
  frame.origin = Vec3(3.25, -7.5, 11.0);
  frame.axes = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-1.1, Vec3::UnitX()))
                   .toRotationMatrix();
  return frame;
}

/// Coarse facets of a body that lies askew.
inline AnalyticOptions tilted() {
  AnalyticOptions options;
  options.frame = tilted_frame();
  options.deflection = 0.1;
  return options;
}

struct Sample {
  std::string name;
  Model model;
  std::function<double(const Vec3&)> depth;  ///< signed distance to the boundary: > 0 inside
  double volume;
  Frame frame;
};

inline double box_depth(const Vec3& p, const Vec3& lo, const Vec3& hi) {
  const Vec3 outside = (lo - p).cwiseMax(p - hi);
  const double away = outside.cwiseMax(Vec3::Zero()).norm();
  return away > 0.0 ? -away : -outside.maxCoeff();
}

/// Every single-region model, in the given frame.
inline std::vector<Sample> all_samples(const Frame& frame = {}, double deflection = 1e-2) {
  const AnalyticOptions options{frame, deflection};
  const double pi = 3.14159265358979323846;
  std::vector<Sample> samples;
  const auto add = [&](const char* name, Model model, std::function<double(const Vec3&)> depth,
                       double volume) {
    const auto local = [frame, depth](const Vec3& p) {
      return depth(frame.axes.transpose() * (p - frame.origin));
    };
    samples.push_back({name, std::move(model), local, volume, frame});
  };
  add(
      "box", analytic_box(Vec3(1, 2, 3), options),
      [](const Vec3& p) { return box_depth(p, Vec3::Zero(), Vec3(1, 2, 3)); }, 6.0);
  const double angle = 0.3;
  add(
      "wedge", analytic_wedge(angle, 2.0, 1.0, options),
      [angle](const Vec3& p) {
        const Vec3 a(2, 0, 0), b(2 * std::cos(angle), 2 * std::sin(angle), 0);
        const Vec3 far = Vec3((b - a).y(), -(b - a).x(), 0).normalized();
        const Vec3 up(-std::sin(angle), std::cos(angle), 0);
        return std::min({p.y(), -up.dot(p), -far.dot(p - a), p.z(), 1.0 - p.z()});
      },
      2.0 * std::sin(angle));
  add(
      "ball", analytic_ball(1.5, options), [](const Vec3& p) { return 1.5 - p.norm(); },
      4.0 / 3.0 * pi * 3.375);
  add(
      "hollow ball", analytic_hollow_ball(2.0, 1.0, options),
      [](const Vec3& p) { return std::min(2.0 - p.norm(), p.norm() - 1.0); }, 4.0 / 3.0 * pi * 7.0);
  add(
      "box minus ball", analytic_box_minus_ball(3.0, 1.0, options),
      [](const Vec3& p) {
        return std::min(box_depth(p, Vec3::Constant(-1.5), Vec3::Constant(1.5)), p.norm() - 1.0);
      },
      27.0 - 4.0 / 3.0 * pi);
  add(
      "cylinder", analytic_cylinder(1.0, 2.5, options),
      [](const Vec3& p) {
        return std::min({1.0 - p.head<2>().norm(), p.z(), 2.5 - p.z()});
      },
      2.5 * pi);
  add(
      "cone", analytic_cone(1.0, 2.0, options),
      [](const Vec3& p) {
        return std::min((2.0 * (1.0 - p.head<2>().norm()) - p.z()) / std::sqrt(5.0), p.z());
      },
      pi * 2.0 / 3.0);
  add(
      "torus", analytic_torus(2.0, 0.5, options),
      [](const Vec3& p) { return 0.5 - std::hypot(p.head<2>().norm() - 2.0, p.z()); }, pi * pi);
  return samples;
}

}  // namespace octet::test
