// SPDX-License-Identifier: BSD-3-Clause
// Bodies and faces that the analytic models are made of.
#include "geom/analytic_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/constants.h"
#include "geom/conics.h"
#include "geom/quadrics.h"
#include "geom/uv_trims.h"

namespace octet {
namespace {

/// Trims call a point "on" within this share of the face's size.
constexpr double kOnShare = 1e-12;

/// Edges of a polyhedron, made at their first use.
class EdgeMap {
 public:
  EdgeMap(PartsBuilder& builder, const std::vector<Vec3>& points, const std::vector<int>& vertices)
      : builder_(builder), points_(points), vertices_(vertices) {}

  FaceBoundary use(int from, int to) {
    const auto key = std::minmax(from, to);
    auto it = edges_.find(key);
    if (it == edges_.end()) {
      const Vec3 d = points_[key.second] - points_[key.first];
      const double length = d.norm();
      const int edge = builder_.add_edge(make_line(points_[key.first], d / length, 0.0, length),
                                         {vertices_[key.first], vertices_[key.second]}, 0.0, length, 1);
      it = edges_.emplace(std::pair<int, int>(key), edge).first;
    }
    return {it->second, from < to ? 1 : -1};
  }

 private:
  PartsBuilder& builder_;
  const std::vector<Vec3>& points_;
  const std::vector<int>& vertices_;
  std::map<std::pair<int, int>, int> edges_;
};

/// Plane through three corners, x along the first side, z = the normal.
Axes3 plane_axes(const Vec3& a, const Vec3& b, const Vec3& c) {
  Axes3 axes;
  axes.origin = a;
  axes.x = (b - a).normalized();
  axes.z = (b - a).cross(c - a).normalized();
  axes.y = axes.z.cross(axes.x);
  return axes;
}

}  // namespace

Axes3 placed(const AnalyticOptions& options, const Vec3& local_origin) {
  const Eigen::Matrix3d& m = options.frame.axes;
  return {options.frame.origin + m * local_origin, m.col(0), m.col(1), m.col(2)};
}

int circle_steps(double radius, double deflection) {
  const double share = std::clamp(0.5 * deflection / radius, 1e-7, 0.1);
  return std::max(12, static_cast<int>(std::ceil(kPi / std::acos(1.0 - share))));
}

std::vector<double> spaced(double a, double b, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(i == steps ? b : a + (b - a) * i / steps);
  return values;
}

void add_polyhedron(PartsBuilder& builder, const AnalyticOptions& options, const std::vector<Vec3>& points,
                    const std::vector<Polygon>& polygons) {
  const Axes3 frame = placed(options);
  std::vector<Vec3> world;
  std::vector<int> vertices;
  for (const Vec3& p : points) {
    world.push_back(frame.to_world(p));
    vertices.push_back(builder.add_vertex(world.back()));
  }
  EdgeMap edges(builder, world, vertices);
  for (const Polygon& polygon : polygons) {
    const auto& c = polygon.corners;
    const Axes3 axes = plane_axes(world[c[0]], world[c[1]], world[c[2]]);
    ModelFace face;
    std::vector<Vec2> uv;
    double size = 0.0, area = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
      face.boundary.push_back(edges.use(c[i], c[(i + 1) % c.size()]));
      uv.push_back(axes.to_local(world[c[i]]).head<2>());
      size = std::max(size, uv.back().norm());
    }
    for (std::size_t i = 1; i + 1 < uv.size(); ++i) {
      const Vec2 a = uv[i] - uv[0], b = uv[i + 1] - uv[0];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    face.region = polygon.region;
    face.area = area;
    const int tag = builder.add_face(make_plane(axes), make_polygon_trim(uv, kOnShare * size), face);
    for (std::size_t i = 1; i + 1 < c.size(); ++i)
      builder.add_triangle(tag,
                           {builder.vertex_node(vertices[c[0]]), builder.vertex_node(vertices[c[i]]),
                            builder.vertex_node(vertices[c[i + 1]])},
                           {uv[0], uv[i], uv[i + 1]});
  }
}

NodeGrid make_grid(PartsBuilder& builder, const Surface& surface, std::vector<double> u,
                   std::vector<double> v, const std::vector<std::uint32_t>& bottom,
                   const std::vector<std::uint32_t>& top, const std::vector<std::uint32_t>& left,
                   const std::vector<std::uint32_t>& right) {
  NodeGrid grid;
  // An edge of one node is a pole: the whole row is that node.
  const auto row_node = [](const std::vector<std::uint32_t>& row, std::size_t i) {
    return row.size() == 1 ? row[0] : row[i];
  };
  const std::size_t columns = u.size(), rows = v.size();
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      if (j == 0)
        grid.node.push_back(row_node(bottom, i));
      else if (j + 1 == rows)
        grid.node.push_back(row_node(top, i));
      else if (i == 0)
        grid.node.push_back(left[j]);
      else if (i + 1 == columns)
        grid.node.push_back(right[j]);
      else
        grid.node.push_back(builder.add_node(surface.evaluate(Vec2(u[i], v[j]), 0).p));
    }
  grid.u = std::move(u);
  grid.v = std::move(v);
  return grid;
}

void add_grid(PartsBuilder& builder, int face, const NodeGrid& grid) {
  for (std::size_t j = 0; j + 1 < grid.v.size(); ++j)
    for (std::size_t i = 0; i + 1 < grid.u.size(); ++i) {
      const std::uint32_t a = grid.at(i, j), b = grid.at(i + 1, j), c = grid.at(i + 1, j + 1),
                          d = grid.at(i, j + 1);
      const double u0 = grid.u[i], u1 = grid.u[i + 1], um = 0.5 * (u0 + u1);
      const double v0 = grid.v[j], v1 = grid.v[j + 1];
      // At a pole every u is the same point: the middle one keeps the map straight.
      const double ua = a == b ? um : u0, uc = c == d ? um : u1;
      builder.add_triangle(face, {a, b, c}, {Vec2(ua, v0), Vec2(u1, v0), Vec2(uc, v1)});
      builder.add_triangle(face, {a, c, d}, {Vec2(ua, v0), Vec2(uc, v1), Vec2(u0, v1)});
    }
}

void add_sphere(PartsBuilder& builder, const AnalyticOptions& options, double radius,
                std::array<int, 2> region, bool reversed) {
  const Axes3 axes = placed(options);
  const int steps = circle_steps(radius, options.deflection), rows = std::max(6, steps / 2);
  const int south = builder.add_vertex(axes.to_world(Vec3(0, 0, -radius)));
  const int north = builder.add_vertex(axes.to_world(Vec3(0, 0, radius)));
  const Axes3 meridian{axes.origin, axes.x, axes.z, -axes.y};
  const int low = builder.add_degenerate_edge(south);
  const int seam = builder.add_edge(make_circle(meridian, radius, -0.5 * kPi, 0.5 * kPi), {south, north},
                                    -0.5 * kPi, 0.5 * kPi, rows, EdgeUse::kSeam);
  const int high = builder.add_degenerate_edge(north);
  ModelFace face;
  face.boundary = {{low, 1}, {seam, 1}, {high, -1}, {seam, -1}};
  face.region = region;
  face.reversed = reversed;
  face.euler = 2;
  face.area = 4.0 * kPi * radius * radius;
  const auto surface = make_sphere(axes, radius);
  const int tag = builder.add_face(surface, make_whole_trim(), face);
  const auto& seam_nodes = builder.edge_nodes(seam);
  const NodeGrid grid =
      make_grid(builder, *surface, spaced(0.0, kTwoPi, steps), spaced(-0.5 * kPi, 0.5 * kPi, rows),
                {builder.vertex_node(south)}, {builder.vertex_node(north)}, seam_nodes, seam_nodes);
  add_grid(builder, tag, grid);
}

void add_disc(PartsBuilder& builder, const Axes3& axes, double radius, int rim, bool reversed) {
  ModelFace face;
  face.boundary = {{rim, reversed ? -1 : 1}};
  face.region = {1, 0};
  face.reversed = reversed;
  face.area = kPi * radius * radius;
  const int tag =
      builder.add_face(make_plane(axes), make_disc_trim(Vec2::Zero(), radius, kOnShare * radius), face);
  const std::uint32_t centre = builder.add_node(axes.origin);
  const auto& nodes = builder.edge_nodes(rim);
  const auto at = [&](std::size_t i) {
    const double angle = kTwoPi * static_cast<double>(i) / static_cast<double>(nodes.size() - 1);
    return Vec2(radius * std::cos(angle), radius * std::sin(angle));
  };
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    builder.add_triangle(tag, {centre, nodes[i], nodes[i + 1]}, {Vec2(0.0, 0.0), at(i), at(i + 1)});
}

}  // namespace octet
