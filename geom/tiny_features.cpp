// SPDX-License-Identifier: BSD-3-Clause
// Edges and faces that are no larger than the CAD knows where they are.
#include "geom/tiny_features.h"

#include <algorithm>

namespace octet {
namespace {

double least_gap(const Model& model) { return kRoundingShare * model.diagonal(); }

/// Of an edge and its vertices.
double gap_around(const Model& model, const ModelEdge& edge) {
  const double vertices =
      std::max(model.vertex(edge.vertex[0]).tolerance, model.vertex(edge.vertex[1]).tolerance);
  return std::max(least_gap(model), 2.0 * std::max(edge.tolerance, vertices));
}

TinyFeature measured(const Model& model, int tag, const ModelEdge& edge) {
  return {model_edge(tag), edge.length, gap_around(model, edge),
          model.edge_point(tag, 0.5 * (edge.t0 + edge.t1))};
}

TinyFeature measured(const Model& model, int tag, const ModelFace& face) {
  TinyFeature feature{model_face(tag), face.area, least_gap(model), Vec3::Zero()};
  double perimeter = 0.0;
  for (const FaceBoundary& side : face.boundary) {
    const ModelEdge& edge = model.edge(side.edge);
    if (edge.use != EdgeUse::kReal) continue;
    perimeter += edge.length;
    feature.gap = std::max(feature.gap, gap_around(model, edge));
    feature.place = model.edge_point(side.edge, 0.5 * (edge.t0 + edge.t1));
  }
  // A face without a border has no sides to lie close together.
  feature.size = perimeter > 0.0 ? 2.0 * face.area / perimeter : face.area / feature.gap;
  return feature;
}

bool is_tiny(const TinyFeature& feature) { return feature.size <= feature.gap; }

/// Edges, then faces, with their sizes.
template <class Visit>
void visit_features(const Model& model, const Visit& visit) {
  for (int e = 1; e <= model.count(1); ++e)
    if (model.edge(e).use == EdgeUse::kReal) visit(measured(model, e, model.edge(e)));
  for (int f = 1; f <= model.count(2); ++f) visit(measured(model, f, model.face(f)));
}

}  // namespace

std::vector<TinyFeature> tiny_features(const Model& model) {
  std::vector<TinyFeature> features;
  visit_features(model, [&](const TinyFeature& feature) {
    if (is_tiny(feature)) features.push_back(feature);
  });
  return features;
}

std::size_t features_within(const Model& model, double length) {
  std::size_t count = 0;
  visit_features(model, [&](const TinyFeature& feature) { count += feature.size <= length ? 1 : 0; });
  return count;
}

bool is_sliver(const Model& model, int face) { return is_tiny(measured(model, face, model.face(face))); }

}  // namespace octet
