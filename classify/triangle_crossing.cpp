// SPDX-License-Identifier: BSD-3-Clause
// Signs of orient3d only; in a plane, points are projected along an axis and lifted to ask the same
// predicate.
#include "classify/triangle_crossing.h"

#include <cmath>

#include "base/predicates.h"

namespace octet {
namespace {

/// Exact orientations within a plane, seen along the axis that sees it widest.
class PlaneView {
 public:
  PlaneView(const Vec3& a, const Vec3& b, const Vec3& c) { (b - a).cross(c - a).cwiseAbs().maxCoeff(&axis_); }
  [[nodiscard]] int orient(const Vec3& p, const Vec3& q, const Vec3& r) const {
    const Vec3 a = flat(p);
    return orient3d(a, flat(q), flat(r), Vec3(a.x(), a.y(), 1.0));
  }

 private:
  [[nodiscard]] Vec3 flat(const Vec3& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3], 0.0}; }
  Eigen::Index axis_ = 0;
};

bool in_triangle(const PlaneView& view, const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int s = view.orient(a, b, p), t = view.orient(b, c, p), u = view.orient(c, a, p);
  return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

/// Doubles tell the sign of a product of differences whose square is more than this share of the squared
/// lengths' product: their error is 1e-14 of the lengths'.
constexpr double kClear = 1e-24;

/// Whether p and q lie beyond the side ab of a triangle so far that doubles are enough. `normal` is the
/// product of two of its sides, `sides` that of their squared lengths.
bool clearly_beyond(const Vec3& normal, double sides, const Vec3& p, const Vec3& q, const Vec3& a,
                    const Vec3& b) {
  const Vec3 ab = b - a, ap = p - a, aq = q - a, inward = normal.cross(ab);
  const double p_in = inward.dot(ap), q_in = inward.dot(aq);
  if (!(p_in < 0.0 && q_in < 0.0)) return false;
  const double clear = kClear * sides * ab.squaredNorm();
  return p_in * p_in > clear * ap.squaredNorm() && q_in * q_in > clear * aq.squaredNorm();
}

/// Proper crossings only: the others have an end within the triangle, or a corner on the segment, which the
/// other two sides then cross or touch as well.
bool cross(const PlaneView& view, const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const int s = view.orient(p, q, a), t = view.orient(p, q, b);
  const int u = view.orient(a, b, p), v = view.orient(a, b, q);
  return s * t <= 0 && u * v <= 0 && (s != 0 || t != 0);
}

bool meets_in_plane(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const PlaneView view(a, b, c);
  return in_triangle(view, p, a, b, c) || in_triangle(view, q, a, b, c) || cross(view, p, q, a, b) ||
         cross(view, p, q, b, c) || cross(view, p, q, c, a);
}

}  // namespace

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
  const double sides = ab.squaredNorm() * ac.squaredNorm();
  if (clearly_beyond(normal, sides, p, q, a, b) || clearly_beyond(normal, sides, p, q, b, c) ||
      clearly_beyond(normal, sides, p, q, c, a))
    return false;
  const int above = orient3d(a, b, c, p), below = orient3d(a, b, c, q);
  if (above * below > 0) return false;
  if (above == 0 && below == 0) return meets_in_plane(p, q, a, b, c);
  const int s = orient3d(p, q, a, b), t = orient3d(p, q, b, c), u = orient3d(p, q, c, a);
  return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

bool segment_enters_triangle(const Vec3& a, const Vec3& q, const Vec3& b, const Vec3& c) {
  // Doubles tell nearly always that q is off the plane or beside the corner.
  const Vec3 ab = b - a, ac = c - a, aq = q - a, normal = ab.cross(ac);
  const double ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm(), most = kClear * ab2 * ac2 * aq.squaredNorm();
  const double above = normal.dot(aq), past_b = normal.dot(aq.cross(ab)), past_c = normal.dot(ac.cross(aq));
  if (above * above > most || (past_b > 0.0 && past_b * past_b > most * ab2) ||
      (past_c > 0.0 && past_c * past_c > most * ac2))
    return false;
  if (orient3d(a, b, c, q) != 0) return false;
  const PlaneView view(a, b, c);
  const int turn = view.orient(a, b, c);
  return view.orient(a, b, q) * turn >= 0 && view.orient(a, q, c) * turn >= 0;
}

}  // namespace octet
