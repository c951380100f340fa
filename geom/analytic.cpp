// SPDX-License-Identifier: BSD-3-Clause
// Models with exact closed forms.
#include "geom/analytic.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/constants.h"
#include "geom/analytic_faces.h"
#include "geom/conics.h"
#include "geom/quadrics.h"
#include "geom/torus.h"
#include "geom/uv_trims.h"

namespace octet {
namespace {

/// Corners of a box in the order x fastest, then y, then z.
std::vector<Vec3> box_corners(const Vec3& lo, const Vec3& hi) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? hi.x() : lo.x(), i & 2 ? hi.y() : lo.y(), i & 4 ? hi.z() : lo.z());
  return corners;
}

/// x-, x+, y-, y+, z-, z+ with outward normals.
std::vector<Polygon> box_polygons() {
  return {{{0, 4, 6, 2}, {1, 0}}, {{1, 3, 7, 5}, {1, 0}}, {{0, 1, 5, 4}, {1, 0}},
          {{2, 6, 7, 3}, {1, 0}}, {{0, 2, 3, 1}, {1, 0}}, {{4, 5, 7, 6}, {1, 0}}};
}

/// Rows along the generatrices so that facets are not much longer than wide.
int side_rows(double length, double radius, int steps) {
  const double width = kTwoPi * radius / steps;
  return std::clamp(static_cast<int>(std::lround(length / (4.0 * width))), 1, 64);
}

/// A circle of the given height in the frame; starts and ends at `vertex`.
int add_rim(PartsBuilder& builder, const AnalyticOptions& options, double radius, double z, int vertex,
            int steps) {
  return builder.add_edge(make_circle(placed(options, Vec3(0, 0, z)), radius, 0.0, kTwoPi), {vertex, vertex},
                          0.0, kTwoPi, steps);
}

}  // namespace

Model analytic_box(const Vec3& size, const AnalyticOptions& options) {
  PartsBuilder builder;
  builder.add_region(size.prod());
  add_polyhedron(builder, options, box_corners(Vec3::Zero(), size), box_polygons());
  return Model(builder.finish());
}

Model analytic_two_boxes(const Vec3& size, const AnalyticOptions& options) {
  PartsBuilder builder;
  builder.add_region(size.prod());
  builder.add_region(size.prod());
  std::vector<Vec3> points = box_corners(Vec3::Zero(), size);
  // 8..11 continue the corners 1, 3, 5, 7 of the shared face to twice the length.
  for (const int i : {1, 3, 5, 7}) points.emplace_back(2.0 * size.x(), points[i].y(), points[i].z());
  std::vector<Polygon> polygons = box_polygons();
  polygons[1].region = {1, 2};
  polygons.push_back({{8, 9, 11, 10}, {2, 0}});
  polygons.push_back({{1, 8, 10, 5}, {2, 0}});
  polygons.push_back({{3, 7, 11, 9}, {2, 0}});
  polygons.push_back({{1, 3, 9, 8}, {2, 0}});
  polygons.push_back({{5, 10, 11, 7}, {2, 0}});
  add_polyhedron(builder, options, points, polygons);
  return Model(builder.finish());
}

Model analytic_wedge(double angle, double length, double height, const AnalyticOptions& options) {
  OCTET_CHECK(angle > 0.0 && angle < kPi);
  PartsBuilder builder;
  builder.add_region(0.5 * length * length * std::sin(angle) * height);
  const Vec3 x(length, 0, 0), y(length * std::cos(angle), length * std::sin(angle), 0), z(0, 0, height);
  const std::vector<Vec3> points{Vec3::Zero(), x, y, z, x + z, y + z};
  add_polyhedron(builder, options, points,
                 {{{0, 1, 4, 3}, {1, 0}},
                  {{1, 2, 5, 4}, {1, 0}},
                  {{2, 0, 3, 5}, {1, 0}},
                  {{0, 2, 1}, {1, 0}},
                  {{3, 4, 5}, {1, 0}}});
  return Model(builder.finish());
}

Model analytic_ball(double radius, const AnalyticOptions& options) {
  PartsBuilder builder;
  builder.add_region(4.0 / 3.0 * kPi * radius * radius * radius);
  add_sphere(builder, options, radius, {1, 0}, false);
  return Model(builder.finish());
}

Model analytic_hollow_ball(double outer, double inner, const AnalyticOptions& options) {
  OCTET_CHECK(inner < outer);
  PartsBuilder builder;
  builder.add_region(4.0 / 3.0 * kPi * (outer * outer * outer - inner * inner * inner));
  add_sphere(builder, options, outer, {1, 0}, false);
  add_sphere(builder, options, inner, {1, 0}, true);
  return Model(builder.finish());
}

Model analytic_box_minus_ball(double side, double radius, const AnalyticOptions& options) {
  OCTET_CHECK(2.0 * radius < side);
  PartsBuilder builder;
  builder.add_region(side * side * side - 4.0 / 3.0 * kPi * radius * radius * radius);
  add_polyhedron(builder, options, box_corners(Vec3::Constant(-0.5 * side), Vec3::Constant(0.5 * side)),
                 box_polygons());
  add_sphere(builder, options, radius, {1, 0}, true);
  return Model(builder.finish());
}

Model analytic_cylinder(double radius, double height, const AnalyticOptions& options) {
  PartsBuilder builder;
  builder.add_region(kPi * radius * radius * height);
  const Axes3 axes = placed(options);
  const int steps = circle_steps(radius, options.deflection), rows = side_rows(height, radius, steps);
  const int low = builder.add_vertex(axes.to_world(Vec3(radius, 0, 0)));
  const int high = builder.add_vertex(axes.to_world(Vec3(radius, 0, height)));
  const int top = add_rim(builder, options, radius, height, high, steps);
  const int seam = builder.add_edge(make_line(axes.to_world(Vec3(radius, 0, 0)), axes.z, 0.0, height),
                                    {low, high}, 0.0, height, rows, EdgeUse::kSeam);
  const int bottom = add_rim(builder, options, radius, 0.0, low, steps);
  ModelFace face;
  face.boundary = {{bottom, 1}, {seam, 1}, {top, -1}, {seam, -1}};
  face.region = {1, 0};
  face.euler = 0;
  face.area = kTwoPi * radius * height;
  const auto surface = make_cylinder(axes, radius);
  const int tag = builder.add_face(surface, make_band_trim(0.0, height, 1e-12 * height), face);
  const auto& seam_nodes = builder.edge_nodes(seam);
  add_grid(builder, tag,
           make_grid(builder, *surface, spaced(0.0, kTwoPi, steps), spaced(0.0, height, rows),
                     builder.edge_nodes(bottom), builder.edge_nodes(top), seam_nodes, seam_nodes));
  add_disc(builder, placed(options, Vec3(0, 0, height)), radius, top, false);
  add_disc(builder, axes, radius, bottom, true);
  return Model(builder.finish());
}

Model analytic_cone(double radius, double height, const AnalyticOptions& options) {
  PartsBuilder builder;
  builder.add_region(kPi * radius * radius * height / 3.0);
  const Axes3 axes = placed(options);
  const double slant = std::hypot(radius, height);
  const int steps = circle_steps(radius, options.deflection), rows = side_rows(slant, radius, steps);
  const Vec3 start = axes.to_world(Vec3(radius, 0, 0)), tip = axes.to_world(Vec3(0, 0, height));
  const int low = builder.add_vertex(start);
  const int apex = builder.add_vertex(tip);
  const int pole = builder.add_degenerate_edge(apex);
  const int seam = builder.add_edge(make_line(start, (tip - start) / slant, 0.0, slant), {low, apex}, 0.0,
                                    slant, rows, EdgeUse::kSeam);
  const int rim = add_rim(builder, options, radius, 0.0, low, steps);
  ModelFace face;
  face.boundary = {{rim, 1}, {seam, 1}, {pole, -1}, {seam, -1}};
  face.region = {1, 0};
  face.area = kPi * radius * slant;
  const auto surface = make_cone(axes, -std::atan2(radius, height), radius);
  const int tag = builder.add_face(surface, make_band_trim(0.0, slant, 1e-12 * slant), face);
  const auto& seam_nodes = builder.edge_nodes(seam);
  add_grid(builder, tag,
           make_grid(builder, *surface, spaced(0.0, kTwoPi, steps), spaced(0.0, slant, rows),
                     builder.edge_nodes(rim), {builder.vertex_node(apex)}, seam_nodes, seam_nodes));
  add_disc(builder, axes, radius, rim, true);
  return Model(builder.finish());
}

Model analytic_torus(double major, double minor, const AnalyticOptions& options) {
  OCTET_CHECK(minor < major);
  PartsBuilder builder;
  builder.add_region(2.0 * kPi * kPi * major * minor * minor);
  const Axes3 axes = placed(options);
  const int around = circle_steps(major + minor, options.deflection);
  const int across = circle_steps(minor, options.deflection);
  const int vertex = builder.add_vertex(axes.to_world(Vec3(major + minor, 0, 0)));
  const Axes3 meridian{axes.to_world(Vec3(major, 0, 0)), axes.x, axes.z, -axes.y};
  const int section = builder.add_edge(make_circle(meridian, minor, 0.0, kTwoPi), {vertex, vertex}, 0.0,
                                       kTwoPi, across, EdgeUse::kSeam);
  const int equator = builder.add_edge(make_circle(axes, major + minor, 0.0, kTwoPi), {vertex, vertex}, 0.0,
                                       kTwoPi, around, EdgeUse::kSeam);
  ModelFace face;
  face.boundary = {{section, 1}, {equator, 1}, {section, -1}, {equator, -1}};
  face.region = {1, 0};
  face.euler = 0;
  face.area = 4.0 * kPi * kPi * major * minor;
  const auto surface = make_torus(axes, major, minor);
  const int tag = builder.add_face(surface, make_whole_trim(), face);
  const auto &section_nodes = builder.edge_nodes(section), &equator_nodes = builder.edge_nodes(equator);
  add_grid(builder, tag,
           make_grid(builder, *surface, spaced(0.0, kTwoPi, around), spaced(0.0, kTwoPi, across),
                     equator_nodes, equator_nodes, section_nodes, section_nodes));
  return Model(builder.finish());
}

}  // namespace octet
