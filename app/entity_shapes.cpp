// SPDX-License-Identifier: BSD-3-Clause
// What geom knows of each entity, put together for people.
#include "app/entity_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "geom/centroids.h"
#include "geom/entity_boxes.h"

namespace octet {
namespace {

Vec3 clean(const Vec3& v, double rounding) {
  return v.unaryExpr([rounding](double c) { return std::abs(c) <= rounding ? 0.0 : c; });
}
Vec3 clean_direction(const Vec3& v) { return clean(v, 1e-12); }

/// Per face the corner of its largest facet that is its middle: far from the edges as facets go.
std::vector<Vec3> facet_middles(const Model& model) {
  std::vector<Vec3> middles(static_cast<std::size_t>(model.count(2)) + 1, Vec3::Zero());
  std::vector<double> largest(middles.size(), -1.0);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const auto [a, b, c] = facet_corners(facets, t);
    const auto f = static_cast<std::size_t>(facets.face[t]);
    const double area = triangle_area(a, b, c);
    if (area <= largest[f]) continue;
    largest[f] = area;
    middles[f] = (a + b + c) / 3.0;
  }
  return middles;
}

/// From the axis, the middle or the middle of a torus' tube to a point of the surface.
Vec3 outwards(const RoundShape& shape, const Vec3& p) {
  const Vec3 from = p - shape.origin;
  if (shape.axis.isZero()) return from;
  const Vec3 across = from - from.dot(shape.axis) * shape.axis;
  return shape.minor_radius > 0.0 ? Vec3(from - shape.radius * across.normalized()) : across;
}

void add_round(const Model& model, int tag, FaceShape& face) {
  face.round = round_shape(model.surface(tag));
  if (!face.round) return;
  RoundShape& round = *face.round;
  face.concave = face.normal.dot(outwards(round, face.point)) < 0.0;
  const std::string_view kind = model.surface(tag).kind();
  if (kind == "cylinder") round.origin += (face.centre - round.origin).dot(round.axis) * round.axis;
  round.origin = clean(round.origin, model.tolerance());
  round.axis = clean_direction(round.axis);
}

void add_radii(const Model& model, std::vector<FaceShape>& faces) {
  const Facets& facets = model.facets();
  std::vector<std::array<double, 2>> heights(faces.size(), {std::numeric_limits<double>::infinity(), 0.0});
  const auto is_cone = [&](int f) { return std::string_view(model.surface(f).kind()) == "cone"; };
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    if (!is_cone(facets.face[t])) continue;
    const RoundShape& cone = *faces[static_cast<std::size_t>(facets.face[t])].round;
    auto& [low, high] = heights[static_cast<std::size_t>(facets.face[t])];
    for (const Vec3& p : facet_corners(facets, t)) {
      const double height = std::abs((p - cone.origin).dot(cone.axis));
      low = std::min(low, height <= model.tolerance() ? 0.0 : height);
      high = std::max(high, height);
    }
  }
  for (std::size_t f = 1; f < faces.size(); ++f)
    if (is_cone(static_cast<int>(f)) && heights[f][1] > 0.0)
      for (std::size_t i = 0; i < 2; ++i)
        faces[f].radii[i] = heights[f][i] * std::tan(faces[f].round->half_angle);
}

FaceShape face_shape(const Model& model, int tag, const Vec3& centre, const Vec3& facet_middle) {
  FaceShape shape;
  shape.centre = clean(centre, model.tolerance());
  const double near = std::max(model.tolerance_of(model_face(tag)), 1e-9 * model.diagonal());
  Foot foot = model.face_closest(tag, shape.centre);
  if (foot.distance <= near && foot.on.dim == 2) {
    shape.point = shape.centre;
  } else {
    foot = model.face_closest(tag, facet_middle);
    shape.point = clean(foot.point, model.tolerance());
  }
  const auto& sides = model.face(tag).region;
  const bool inwards = sides[1] != 0 && (sides[0] == 0 || sides[1] < sides[0]);
  shape.normal = clean_direction(inwards ? -foot.normal : foot.normal);
  return shape;
}

EdgeShape edge_shape(const Model& model, int tag) {
  const ModelEdge& edge = model.edge(tag);
  EdgeShape shape;
  if (edge.use == EdgeUse::kDegenerate) {
    shape.middle = without_rounding(model, model.vertex(edge.vertex[0]).point);
    shape.ends = {shape.middle, shape.middle};
    return shape;
  }
  const double rounding = model.tolerance();
  shape.ends = {clean(model.edge_point(tag, edge.t0), rounding),
                clean(model.edge_point(tag, edge.t1), rounding)};
  shape.middle =
      clean(model.edge_point(tag, model.edge_parameter(tag, edge.t0, 0.5 * edge.length)), rounding);
  shape.arc = conic_shape(model.curve(tag));
  if (shape.arc) {
    shape.arc->centre = clean(shape.arc->centre, rounding);
    shape.arc->axis = clean_direction(shape.arc->axis);
  }
  return shape;
}

}  // namespace

Vec3 without_rounding(const Model& model, const Vec3& p) { return clean(p, model.tolerance()); }

EntityShapes entity_shapes(const Model& model) {
  const auto clean_box = [rounding = model.tolerance()](const Box3& box) {
    return box.empty() ? box : Box3{clean(box.lo, rounding), clean(box.hi, rounding)};
  };
  const Centroids centre = centroids(model);
  const EntityBoxes boxes = entity_boxes(model);
  const std::vector<Vec3> middles = facet_middles(model);
  EntityShapes shapes;
  shapes.edges.resize(1);
  for (int e = 1; e <= model.count(1); ++e) {
    shapes.edges.push_back(edge_shape(model, e));
    shapes.edges.back().box = clean_box(boxes.edge[static_cast<std::size_t>(e)]);
    if (shapes.edges.back().box.empty()) shapes.edges.back().box.add(shapes.edges.back().middle);
  }
  shapes.faces.resize(1);
  for (int f = 1; f <= model.count(2); ++f) {
    const auto at = static_cast<std::size_t>(f);
    shapes.faces.push_back(face_shape(model, f, centre.face[at], middles[at]));
    shapes.faces.back().box = clean_box(boxes.face[at]);
    add_round(model, f, shapes.faces.back());
  }
  add_radii(model, shapes.faces);
  for (std::size_t r = 0; r <= static_cast<std::size_t>(model.count(3)); ++r)
    shapes.regions.push_back({clean(centre.region[r], model.tolerance()), clean_box(boxes.region[r])});
  return shapes;
}

}  // namespace octet
