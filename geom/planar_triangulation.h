// SPDX-License-Identifier: BSD-3-Clause
// A triangulation in the plane that keeps its border whatever happens: flips and splits only inside.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Exact sign of the area of (a, b, c): +1 counter-clockwise.
[[nodiscard]] int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Invariants: triangle t's side k joins corners k+1 and k+2, and `neighbour[k]` is the triangle beyond it,
/// none for a border side; neighbours name each other. Sides of the border are never flipped or split.
/// Triangles are counter-clockwise but where the border crosses itself; there some are turned.
class PlanarTriangulation {
 public:
  static constexpr std::int32_t kNone = -1;
  struct Triangle {
    std::array<std::uint32_t, 3> corner;
    std::array<std::int32_t, 3> neighbour{kNone, kNone, kNone};
  };

  std::vector<Vec2> points;
  std::vector<Triangle> triangles;

  /// Makes two sides one another's neighbours.
  void link(std::int32_t t, int side, std::int32_t u, int other_side);
  /// Flips sides, starting at those of the given triangles, until all are Delaunay [Handbook 1.3]; a turned
  /// triangle is flipped away where that makes both new ones positive. Bounded by 40 flips per triangle.
  void legalize(std::vector<std::int32_t> triangles_to_check);
  /// A new point in the middle of side k of triangle t, which is no border side; returns its index, none
  /// where both triangles have the same corners.
  std::optional<std::uint32_t> split_side(std::int32_t t, int side);
  /// A new point at the centroid of triangle t; returns its index.
  std::uint32_t split_triangle(std::int32_t t);

 private:
  [[nodiscard]] int side_to(std::int32_t t, std::int32_t neighbour, std::uint32_t corner_a) const;
  [[nodiscard]] bool wants_flip(std::int32_t t, int side) const;
  void flip(std::int32_t t, int side);
  void relink(std::int32_t neighbour, std::int32_t old_triangle, std::int32_t t, int side);
};

/// Triangulates the polygon to the left of its loops: each loop lists indices into `points`,
/// counter-clockwise for an outer one, clockwise for a hole. Every side of every loop is a border side of one
/// triangle, in the loop's direction, even where loops cross or touch: watertight by construction. No
/// triangles: no loop is counter-clockwise. Cost: quadratic in the number of corners, then Delaunay flips.
[[nodiscard]] PlanarTriangulation triangulate_loops(std::vector<Vec2> points,
                                                    const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace octet
