// SPDX-License-Identifier: BSD-3-Clause
// A quick "in": most points of a face need no exact trimming.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "geom/model_data.h"

namespace octet {

/// Distance from x to the chord of a border side.
[[nodiscard]] inline double chord_distance(const Model::Data& data, const BorderSide& side, const Vec3& x) {
  const Vec3 &a = data.facets().nodes[side.a], &b = data.facets().nodes[side.b];
  const Vec3 e = b - a;
  const double ee = e.squaredNorm();
  const double u = ee > 0.0 ? std::clamp((x - a).dot(e) / ee, 0.0, 1.0) : 0.0;
  return (x - a - u * e).norm();
}

/// Whether (u,v) lies in the triangle of the facet's corners in (u,v): 1 where they go about it
/// counter-clockwise, -1 where clockwise, 0 where it does not.
[[nodiscard]] inline int turn_of_facet(const std::array<Vec2, 3>& c, const Vec2& uv) {
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  const double a = cross(c[1] - c[0], uv - c[0]);
  const double b = cross(c[2] - c[1], uv - c[1]);
  const double d = cross(c[0] - c[2], uv - c[2]);
  return a > 0.0 && b > 0.0 && d > 0.0 ? 1 : a < 0.0 && b < 0.0 && d < 0.0 ? -1 : 0;
}

/// True only when the surface point x at (u,v) is surely in the face: in a facet in (u,v), and farther from
/// every border chord than the border's curve may be, and than the side of the facet in (u,v): on the surface
/// it is no chord, and may bulge over a curve that is one. Facets turned over tell nothing: where a face is
/// narrower than its chords are off, they cross, and what is between them is on neither side. `triangles`
/// [first, last) are of the face and hold all that lie within their growth of x; `id` maps an element to its
/// triangle. False decides nothing.
template <class Iterator, class Id>
[[nodiscard]] bool clearly_in_facets(const Model::Data& data, const Vec3& x, const Vec2& uv, Iterator first,
                                     Iterator last, const Id& id) {
  bool in = false;
  for (Iterator it = first; it != last; ++it) {
    const int turn = turn_of_facet(data.facets().uv[id(*it)], uv);
    if (turn == 0) continue;
    if ((turn < 0) != data.parts.faces[data.facets().face[id(*it)]].reversed) return false;
    in = true;
  }
  if (!in) return false;
  constexpr double kClear = 2.0;
  for (Iterator it = first; it != last; ++it)
    for (const std::int32_t s : data.border.of_triangle[id(*it)]) {
      if (s < 0) continue;
      const BorderSide& side = data.border.sides[s];
      const double bulge = data.facets().deviation[data.facets().face[id(*it)]];
      if (chord_distance(data, side, x) <= bulge + kClear * side.reach) return false;
    }
  return true;
}

}  // namespace octet
