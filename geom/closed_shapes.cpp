// SPDX-License-Identifier: BSD-3-Clause
// The parametrisations of geom/quadrics.h, geom/torus.h and geom/conics.h, solved for what they are made of.
#include "geom/closed_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace octet {
namespace {

/// Of a direction and its opposite the one whose largest component is positive.
Vec3 one_way(const Vec3& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0.0 ? Vec3(-direction.normalized()) : Vec3(direction.normalized());
}

RoundShape cone_shape(const Surface& surface) {
  const SurfaceJet jet = surface.evaluate(Vec2::Zero(), 1);
  const SurfaceJet across = surface.evaluate(Vec2(std::numbers::pi, 0.0), 1);
  // The sides run on both of them towards the axis, and meet at the apex.
  const Vec3 away = 0.5 * (jet.p - across.p), spread = 0.5 * (jet.dv - across.dv);
  const Vec3 rise = 0.5 * (jet.dv + across.dv);
  RoundShape shape;
  shape.origin = 0.5 * (jet.p + across.p) - away.dot(spread) / spread.squaredNorm() * rise;
  shape.axis = one_way(rise);
  shape.half_angle = std::atan2(spread.norm(), rise.norm());
  return shape;
}

}  // namespace

std::optional<RoundShape> round_shape(const Surface& surface) {
  const std::string_view kind = surface.kind();
  if (kind == "cone") return cone_shape(surface);
  if (kind != "cylinder" && kind != "sphere" && kind != "torus") return std::nullopt;
  const SurfaceJet jet = surface.evaluate(Vec2::Zero(), 2);
  RoundShape shape;
  shape.origin = jet.p + jet.duu;
  if (kind != "sphere") shape.axis = one_way(jet.dv);
  if (kind == "torus") shape.minor_radius = jet.dvv.norm();
  shape.radius = jet.duu.norm() - shape.minor_radius;
  return shape;
}

std::optional<ConicShape> conic_shape(const Curve& curve) {
  const std::string_view kind = curve.kind();
  if (kind != "circle" && kind != "ellipse") return std::nullopt;
  const Vec3 first = curve.point(0.0), second = curve.derivative(0.0);
  ConicShape shape;
  shape.centre = 0.5 * (first + curve.point(std::numbers::pi));
  const Vec3 out = first - shape.centre;
  shape.axis = one_way(out.cross(second));
  shape.radii = {std::max(out.norm(), second.norm()), std::min(out.norm(), second.norm())};
  return shape;
}

}  // namespace octet
