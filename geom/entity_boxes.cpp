// SPDX-License-Identifier: BSD-3-Clause
// A plane, cylinder or cone is farthest out on its edges; spheres and tori also where they turn back.
#include "geom/entity_boxes.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/golden_section.h"
#include "geom/closed_shapes.h"

namespace octet {
namespace {

constexpr int kSamples = 32;  // of a curve between breaks
constexpr int kCuts = 40;     // a place to 1e-8 of the interval, its height to rounding

/// Adds the highest point along an axis, up (sign 1) or down, near the highest sample.
void add_highest(const Curve& curve, const std::vector<double>& at, Eigen::Index axis, double sign,
                 Box3& box) {
  const auto depth = [&](double t) { return -sign * curve.point(t)[axis]; };
  std::size_t best = 0;
  double least = depth(at[0]);
  for (std::size_t i = 1; i < at.size(); ++i)
    if (const double d = depth(at[i]); d < least) {
      least = d;
      best = i;
    }
  const double low = at[best == 0 ? 0 : best - 1], high = at[std::min(best + 1, at.size() - 1)];
  const auto [t, lowest] = golden_section(low, high, kCuts, depth);
  if (lowest < least) box.add(curve.point(t));
}

Box3 edge_box(const Model& model, int tag) {
  Box3 box;
  const ModelEdge& edge = model.edge(tag);
  if (edge.use == EdgeUse::kDegenerate) return box;
  const Curve& curve = model.curve(tag);
  box.add(curve.point(edge.t0));
  box.add(curve.point(edge.t1));
  if (std::string_view(curve.kind()) == "line") return box;
  std::vector<double> breaks = curve.breaks(), at;
  if (breaks.size() < 2) breaks = {edge.t0, edge.t1};
  for (std::size_t i = 1; i < breaks.size(); ++i)
    for (int k = 0; k < kSamples; ++k)
      at.push_back(breaks[i - 1] + k * (breaks[i] - breaks[i - 1]) / kSamples);
  at.push_back(breaks.back());
  for (const double t : at) box.add(curve.point(t));
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) add_highest(curve, at, axis, sign, box);
  return box;
}

/// The point of the whole surface that is farthest out in a direction.
Vec3 farthest(const RoundShape& shape, const Vec3& direction) {
  if (shape.axis.isZero()) return shape.origin + shape.radius * direction;
  const Vec3 across = direction - direction.dot(shape.axis) * shape.axis;
  const Vec3 out = across.norm() > 1e-9 ? Vec3(across.normalized()) : shape.axis.unitOrthogonal();
  return shape.origin + shape.radius * out + shape.minor_radius * direction;
}

/// Where a sphere or torus turns back within the face, which no edge of it need reach.
void add_turns(const Model& model, int face, Box3& box) {
  const std::string_view kind = model.surface(face).kind();
  if (kind != "sphere" && kind != "torus") return;
  const auto shape = round_shape(model.surface(face));
  const double near = std::max(model.tolerance(), 1e-9 * model.diagonal());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 p = farthest(*shape, sign * Vec3::Unit(axis));
      if (!box.empty() && box.contains(p)) continue;
      if (model.face_closest(face, p).distance <= near) box.add(p);
    }
}

Box3 face_box(const Model& model, int tag, const std::vector<Box3>& edges, const Box3& facets) {
  const bool round = round_shape(model.surface(tag)).has_value();
  if (!round && !model.is_plane(tag))
    return facets.grown(model.facets().deviation[static_cast<std::size_t>(tag)]);
  Box3 box;
  const ModelFace& face = model.face(tag);
  for (const FaceBoundary& side : face.boundary) box.add(edges[static_cast<std::size_t>(side.edge)]);
  for (const int v : face.vertices) box.add(model.vertex(v).point);
  add_turns(model, tag, box);
  return box.empty() ? facets : box;
}

}  // namespace

EntityBoxes entity_boxes(const Model& model) {
  EntityBoxes boxes;
  boxes.edge.resize(1);
  for (int e = 1; e <= model.count(1); ++e) boxes.edge.push_back(edge_box(model, e));
  std::vector<Box3> of_facets(static_cast<std::size_t>(model.count(2)) + 1);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const Vec3& p : facet_corners(facets, t)) of_facets[static_cast<std::size_t>(facets.face[t])].add(p);
  boxes.face.resize(1);
  for (int f = 1; f <= model.count(2); ++f)
    boxes.face.push_back(face_box(model, f, boxes.edge, of_facets[static_cast<std::size_t>(f)]));
  boxes.region.resize(1);
  for (int r = 1; r <= model.count(3); ++r) {
    boxes.region.emplace_back();
    for (const int f : model.region(r).faces)
      boxes.region.back().add(boxes.face[static_cast<std::size_t>(f)]);
  }
  return boxes;
}

}  // namespace octet
