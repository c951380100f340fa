// SPDX-License-Identifier: BSD-3-Clause
// A triangulation in the plane that keeps its border whatever happens: flips and splits only inside.
#include "geom/planar_triangulation.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/predicates.h"

namespace octet {
namespace {

constexpr int kFlipsPerTriangle = 40;

/// Twice the area times the cotangent form of "d lies in the circle of abc", for a counter-clockwise abc.
double in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 p = a - d, q = b - d, r = c - d;
  const auto cross = [](const Vec2& x, const Vec2& y) { return x.x() * y.y() - x.y() * y.x(); };
  return p.squaredNorm() * cross(q, r) + q.squaredNorm() * cross(r, p) + r.squaredNorm() * cross(p, q);
}

}  // namespace

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  // [Shewchuk 1997, fig. 21], but for products that underflow.
  constexpr double kError = 4.0 * 0x1p-53, kSmallest = 1e-290;
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double twice_area = left - right;
  if (std::abs(twice_area) > kError * (std::abs(left) + std::abs(right)) + kSmallest)
    return twice_area > 0.0 ? 1 : -1;
  return orient3d({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}, {c.x(), c.y(), 0.0}, {c.x(), c.y(), 1.0});
}

void PlanarTriangulation::link(std::int32_t t, int side, std::int32_t u, int other_side) {
  triangles[t].neighbour[side] = u;
  triangles[u].neighbour[other_side] = t;
}

/// The side of `t` beyond which `neighbour` lies, and which starts at corner `corner_a`.
int PlanarTriangulation::side_to(std::int32_t t, std::int32_t neighbour, std::uint32_t corner_a) const {
  for (int k = 0; k < 3; ++k)
    if (triangles[t].neighbour[k] == neighbour && triangles[t].corner[(k + 1) % 3] == corner_a) return k;
  return -1;
}

void PlanarTriangulation::relink(std::int32_t neighbour, std::int32_t old_triangle, std::int32_t t,
                                 int side) {
  triangles[t].neighbour[side] = neighbour;
  if (neighbour == kNone) return;
  const int k = side_to(neighbour, old_triangle, triangles[t].corner[(side + 2) % 3]);
  OCTET_CHECK(k >= 0);
  triangles[neighbour].neighbour[k] = t;
}

/*        c              c
 *       /|\            / \
 *      / | \          / t \
 *     a t|u d   ->   a-----d        side of t opposite a: b-c
 *      \ | /          \ u /
 *       \|/            \ /
 *        b              b                                        */
bool PlanarTriangulation::wants_flip(std::int32_t t, int side) const {
  const std::int32_t u = triangles[t].neighbour[side];
  if (u == kNone || u == t) return false;
  const std::uint32_t ia = triangles[t].corner[side], ib = triangles[t].corner[(side + 1) % 3],
                      ic = triangles[t].corner[(side + 2) % 3];
  const int other = side_to(u, t, ic);
  if (other < 0) return false;
  const std::uint32_t id = triangles[u].corner[other];
  if (id == ia) return false;
  const Vec2 &a = points[ia], &b = points[ib], &c = points[ic], &d = points[id];
  if (orient2d(a, b, d) <= 0 || orient2d(a, d, c) <= 0) return false;
  if (orient2d(a, b, c) <= 0 || orient2d(b, d, c) <= 0) return true;
  const double scale = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm()});
  return in_circle(a, b, c, d) > 1e-12 * scale * scale;
}

void PlanarTriangulation::flip(std::int32_t t, int side) {
  const std::int32_t u = triangles[t].neighbour[side];
  const Triangle old_t = triangles[t], old_u = triangles[u];
  const std::uint32_t a = old_t.corner[side], b = old_t.corner[(side + 1) % 3],
                      c = old_t.corner[(side + 2) % 3];
  const int other = side_to(u, t, c);
  const std::uint32_t d = old_u.corner[other];
  const std::int32_t beyond_ca = old_t.neighbour[(side + 1) % 3], beyond_ab = old_t.neighbour[(side + 2) % 3];
  // In u the side runs from c to b: opposite its first end c lies side b-d, opposite b side d-c.
  const std::int32_t beyond_bd = old_u.neighbour[(other + 1) % 3],
                     beyond_dc = old_u.neighbour[(other + 2) % 3];
  triangles[t].corner = {a, d, c};
  triangles[u].corner = {a, b, d};
  triangles[t].neighbour = {kNone, kNone, kNone};
  triangles[u].neighbour = {kNone, kNone, kNone};
  link(t, 2, u, 1);
  relink(beyond_dc, u, t, 0);
  relink(beyond_ca, t, t, 1);
  relink(beyond_bd, u, u, 0);
  relink(beyond_ab, t, u, 2);
}

void PlanarTriangulation::legalize(std::vector<std::int32_t> stack) {
  auto flips_left =
      static_cast<std::int64_t>(kFlipsPerTriangle) * static_cast<std::int64_t>(triangles.size());
  while (!stack.empty() && flips_left > 0) {
    const std::int32_t t = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      if (!wants_flip(t, k)) continue;
      const std::int32_t u = triangles[t].neighbour[k];
      flip(t, k);
      --flips_left;
      stack.push_back(u);
      stack.push_back(t);
      break;
    }
  }
}

std::optional<std::uint32_t> PlanarTriangulation::split_side(std::int32_t t, int side) {
  const std::int32_t u = triangles[t].neighbour[side];
  const Triangle old_t = triangles[t], old_u = triangles[u];
  const std::uint32_t a = old_t.corner[side], b = old_t.corner[(side + 1) % 3],
                      c = old_t.corner[(side + 2) % 3];
  const int other = side_to(u, t, c);
  const std::uint32_t d = old_u.corner[other];
  if (d == a) return std::nullopt;
  const std::int32_t beyond_ca = old_t.neighbour[(side + 1) % 3],
                     beyond_bd = old_u.neighbour[(other + 1) % 3];
  const auto m = static_cast<std::uint32_t>(points.size());
  points.push_back(0.5 * (points[b] + points[c]));
  // t keeps b and takes m for c; u keeps c and takes m for b; two new ones hold the other halves.
  const auto v = static_cast<std::int32_t>(triangles.size()), w = v + 1;
  triangles[t].corner[(side + 2) % 3] = m;
  triangles[u].corner[(other + 2) % 3] = m;
  triangles.push_back({{a, m, c}});
  triangles.push_back({{d, m, b}});
  relink(beyond_ca, t, v, 1);
  relink(beyond_bd, u, w, 1);
  link(t, (side + 1) % 3, v, 2);
  link(u, (other + 1) % 3, w, 2);
  link(t, side, w, 0);
  link(u, other, v, 0);
  legalize({t, u, v, w});
  return m;
}

std::uint32_t PlanarTriangulation::split_triangle(std::int32_t t) {
  const Triangle old = triangles[t];
  const auto& [a, b, c] = old.corner;
  const auto m = static_cast<std::uint32_t>(points.size());
  points.push_back((points[a] + points[b] + points[c]) / 3.0);
  const auto u = static_cast<std::int32_t>(triangles.size()), v = u + 1;
  triangles[t] = {{a, b, m}};
  triangles.push_back({{b, c, m}});
  triangles.push_back({{c, a, m}});
  relink(old.neighbour[2], t, t, 2);
  relink(old.neighbour[0], t, u, 2);
  relink(old.neighbour[1], t, v, 2);
  link(t, 0, u, 1);
  link(u, 0, v, 1);
  link(v, 0, t, 1);
  legalize({t, u, v});
  return m;
}

}  // namespace octet
