// SPDX-License-Identifier: BSD-3-Clause
// Bodies and faces that the analytic models are made of, added to a PartsBuilder.
#pragma once

#include <array>
#include <vector>

#include "geom/analytic.h"
#include "geom/parts_builder.h"

namespace octet {

/// The frame of the options moved to a local origin.
[[nodiscard]] Axes3 placed(const AnalyticOptions& options, const Vec3& local_origin = Vec3::Zero());

/// Equal steps of a full circle whose chords stay within half of the deflection.
[[nodiscard]] int circle_steps(double radius, double deflection);

/// A polygon of a polyhedron: corners counter-clockwise seen against its normal.
struct Polygon {
  std::vector<int> corners;  ///< indices into the points
  std::array<int, 2> region{0, 0};
};

/// Convex planar faces on shared vertices and edges; points are local.
void add_polyhedron(PartsBuilder& builder, const AnalyticOptions& options, const std::vector<Vec3>& points,
                    const std::vector<Polygon>& polygons);

/// A sphere: seam, two degenerate edges, two vertices. `reversed`: the normal points to the centre.
void add_sphere(PartsBuilder& builder, const AnalyticOptions& options, double radius,
                std::array<int, 2> region, bool reversed);

/// A planar disc of normal +z (or -z when reversed) whose border is the circle `rim`.
void add_disc(PartsBuilder& builder, const Axes3& axes, double radius, int rim, bool reversed);

/// Nodes over a rectangle of (u,v): rows of v, columns of u.
struct NodeGrid {
  std::vector<double> u, v;
  std::vector<std::uint32_t> node;  ///< row by row
  [[nodiscard]] std::uint32_t at(std::size_t column, std::size_t row) const {
    return node[row * u.size() + column];
  }
};

/// A grid whose inner nodes are new, and whose first and last rows and columns are the given nodes.
[[nodiscard]] NodeGrid make_grid(PartsBuilder& builder, const Surface& surface, std::vector<double> u,
                                 std::vector<double> v, const std::vector<std::uint32_t>& bottom,
                                 const std::vector<std::uint32_t>& top,
                                 const std::vector<std::uint32_t>& left,
                                 const std::vector<std::uint32_t>& right);
void add_grid(PartsBuilder& builder, int face, const NodeGrid& grid);

/// `steps` + 1 equally spaced values from a to b.
[[nodiscard]] std::vector<double> spaced(double a, double b, int steps);

}  // namespace octet
