// SPDX-License-Identifier: BSD-3-Clause
// The partner of a boundary point, by shrinking a ball [Ma, Bae & Choi 2012, section 3].
#include "geom/opposite.h"

#include <cmath>

namespace octet {
namespace {

/// First ball, in units of max_distance: a partner at that distance touches no larger ball unless the two
/// sheets open by more than 2 acos(1/4) = 151 degrees, which nobody calls thin.
constexpr double kFirstRadius = 2.0;

/// Smallest |b - a| / (2 radius), the sine of half the angle between the normals at a and b. Below it b is
/// the smooth neighbourhood of a: the ball has shrunk to the sphere of curvature.
constexpr double kNeighbourSameFace = 0.25;  // 29 degrees
constexpr double kNeighbourOther = 0.05;     // 6 degrees

/// Radius of the ball that touches a along `axis` and passes through b; infinite or negative when none does.
double radius_through(const Vec3& a, const Vec3& axis, const Vec3& b) {
  const Vec3 chord = b - a;
  return chord.squaredNorm() / (2.0 * chord.dot(axis));
}

/// Emptiness of the ball is known to rounding, so the place of b only to its square root. Feet on b's own
/// face or edge go on from there: each step squares the error, since b moves along the ball.
void polish(const Model& model, const Vec3& a, const Vec3& axis, double radius, double slack, Foot& b) {
  // A foot that moves more than the error of b can be is another one.
  const double far = 4.0 * std::sqrt((slack + 1e-12 * radius) * radius);
  constexpr int kSteps = 4;
  double t = b.on.dim == 1 ? model.edge_closest(b.on.tag, b.point).t : 0.0;
  for (int i = 0; i < kSteps && b.on.dim > 0; ++i) {
    const Vec3 centre = a + radius * axis;
    Vec3 next;
    if (b.on.dim == 2) {
      const FaceFoot foot = model.face_project(b.on.tag, centre, b.uv);
      if (!foot.converged) return;
      next = foot.point;
      if ((next - b.point).norm() > far) return;
      b.uv = foot.uv;
      b.normal = foot.normal;
    } else {
      const EdgeFoot foot = model.edge_project(b.on.tag, centre, t);
      t = foot.t;
      next = foot.point;
      if ((next - b.point).norm() > far) return;
    }
    const double moved = (next - b.point).norm();
    b.point = next;
    if (moved <= 1e-14 * radius) return;
    const double r = radius_through(a, axis, next);
    if (!(r > 0.0)) return;
    radius = r;
  }
}

}  // namespace

std::optional<Foot> opposite_point(const Model& model, const Vec3& a, int face_of_a, const Vec3& normal,
                                   int side, double max_distance) {
  const Vec3 axis = side < 0 ? Vec3(-normal) : normal;
  const double slack = 4.0 * model.tolerance();
  double radius = kFirstRadius * max_distance;
  std::optional<Foot> partner;
  constexpr int kMostSteps = 60;
  for (int i = 0; i < kMostSteps; ++i) {
    const Vec3 centre = a + radius * axis;
    const auto near = model.closest(centre, radius);
    // a itself is at distance `radius`: what is not nearer than that leaves the ball empty.
    if (!near || near->distance >= radius * (1.0 - 1e-12) - slack) break;
    const double next = radius_through(a, axis, near->point);
    if (!(next > 0.0 && next < radius)) break;
    radius = next;
    partner = near;
    if (radius <= slack) return std::nullopt;
  }
  if (!partner) return std::nullopt;
  const double apart = (partner->point - a).norm();
  if (apart > max_distance || apart <= slack) return std::nullopt;
  const double least =
      partner->face == face_of_a && partner->on.dim == 2 ? kNeighbourSameFace : kNeighbourOther;
  if (apart < least * 2.0 * radius) return std::nullopt;
  polish(model, a, axis, radius, slack, *partner);
  // The foot moves on the face's whole surface: it may have come to lie on the face's edge, or beyond it.
  if (partner->on.dim == 2) partner = model.face_closest(partner->on.tag, partner->point);
  partner->distance = (partner->point - a).norm();
  return partner;
}

double cosine_between(const Vec3& a, const Vec3& normal, const Foot& b) {
  const Vec3 chord = b.point - a;
  const double same_way = normal.dot(chord) * b.normal.dot(chord) < 0.0 ? -1.0 : 1.0;
  return same_way * normal.dot(b.normal);
}

bool face_each_other(const Vec3& a, const Vec3& normal, const Foot& b) {
  constexpr double kFacing = 0.7;
  return cosine_between(a, normal, b) >= kFacing;
}

}  // namespace octet
