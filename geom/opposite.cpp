// SPDX-License-Identifier: BSD-3-Clause
// The partner of a boundary point, by shrinking a ball [Ma, Bae & Choi 2012, section 3].
#include "geom/opposite.h"

#include <cmath>

#include "geom/facet_bvh.h"

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

/// Least cosine between the normals of sheets that face each other.
constexpr double kFacing = 0.7;

/// All places within reach where a sheet may touch a ball that touches another at a, along `axis`, and face
/// it. The chord to such a place has a cosine of sqrt((1 + kFacing) / 2) = 0.92 with the axis, and more.
Box3 box_ahead(const Vec3& a, const Vec3& axis, double reach) {
  constexpr double kSpread = 0.5;  // sine; 0.39 without a margin
  Box3 box;
  box.add(a);
  for (const double way : {-kSpread, kSpread})
    box.add(a + reach * (axis + way * (Vec3::Ones() - axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt()));
  return box;
}

/// Whether any facet ahead may be of a sheet that faces the one at a. The ball between lies in one region, so
/// the sheet's side towards that region looks back; facets are trusted to about 45 degrees. One that is off
/// by more is thinner than it deviates, and what is beside it is as near.
bool may_face_another(const Model& model, const Vec3& a, int face_of_a, const Vec3& axis, int side,
                      double reach) {
  constexpr double kLeastFacing = 0.05;  // of facets; planes at right angles have rounding
  const int between = model.face(face_of_a).region[side > 0 ? 1 : 0];
  return model.bvh().any_in_box(box_ahead(a, axis, reach), [&](std::uint32_t t) {
    return looks_back(model, t, axis, between, kLeastFacing);
  });
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
  return cosine_between(a, normal, b) >= kFacing;
}

bool looks_back(const Model& model, std::uint32_t facet, const Vec3& axis, int between, double least) {
  const auto [p, q, r] = facet_corners(model.facets(), facet);
  const Vec3 normal = (q - p).cross(r - p);
  const double along = normal.dot(axis);
  if (std::abs(along) < least * normal.norm()) return false;
  return model.face(model.facets().face[facet]).region[along < 0.0 ? 1 : 0] == between;
}

std::optional<Foot> facing_point(const Model& model, const Vec3& a, int face_of_a, const Vec3& normal,
                                 int side, double max_distance) {
  const Vec3 axis = side < 0 ? Vec3(-normal) : normal;
  if (!may_face_another(model, a, face_of_a, axis, side, max_distance)) return std::nullopt;
  std::optional<Foot> b = opposite_point(model, a, face_of_a, normal, side, max_distance);
  if (b && (b->on.dim != 2 || !face_each_other(a, normal, *b))) b.reset();
  return b;
}

}  // namespace octet
