// SPDX-License-Identifier: BSD-3-Clause
// How far the facets are from the exact surfaces and curves.
#include "geom/occt/deviation.h"

#include <algorithm>
#include <cmath>

#include "base/segment.h"

namespace octet {
namespace {

constexpr double kInflate = 1.5;

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double nn = n.squaredNorm();
  if (nn > 0.0) {
    const double wa = (c - b).cross(p - b).dot(n), wb = (a - c).cross(p - c).dot(n),
                 wc = (b - a).cross(p - a).dot(n);
    if (wa >= 0.0 && wb >= 0.0 && wc >= 0.0) return std::abs((p - a).dot(n)) / std::sqrt(nn);
  }
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Distance of the surface from one facet, at its centre, the middles of its sides and between.
double facet_deviation(const Surface& surface, const std::array<Vec2, 3>& uv, const Vec3& a, const Vec3& b,
                       const Vec3& c, bool at_pole) {
  const Vec2 centre = (uv[0] + uv[1] + uv[2]) / 3.0;
  const std::array<Vec2, 7> samples = {centre,
                                       Vec2(0.5 * (uv[0] + uv[1])),
                                       Vec2(0.5 * (uv[1] + uv[2])),
                                       Vec2(0.5 * (uv[2] + uv[0])),
                                       Vec2(0.5 * (centre + uv[0])),
                                       Vec2(0.5 * (centre + uv[1])),
                                       Vec2(0.5 * (centre + uv[2]))};
  // Next to a pole the middle of the (u,v) triangle is not the middle of the facet.
  if (at_pole) {
    const SurfaceFoot foot = surface.project((a + b + c) / 3.0, samples[0]);
    if (foot.converged) return distance_to_triangle(foot.point, a, b, c);
  }
  double worst = 0.0;
  for (const Vec2& sample : samples)
    worst = std::max(worst, distance_to_triangle(surface.evaluate(sample, 0).p, a, b, c));
  return worst;
}

std::vector<bool> pole_nodes(const ModelParts& parts) {
  std::vector<bool> pole(parts.facets.nodes.size(), false);
  for (std::size_t e = 1; e < parts.edges.size(); ++e)
    if (parts.edges[e].use == EdgeUse::kDegenerate)
      pole[static_cast<std::size_t>(parts.edges[e].vertex[0] - 1)] = true;
  return pole;
}

double chain_deviation(const Curve& curve, const ModelEdge& edge, const std::vector<double>& inner) {
  std::vector<double> t = {edge.t0};
  t.insert(t.end(), inner.begin(), inner.end());
  t.push_back(edge.t1);
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const Vec3 a = curve.point(t[i]), b = curve.point(t[i + 1]);
    for (const double share : {0.25, 0.5, 0.75})
      worst = std::max(worst, distance_to_segment(curve.point(t[i] + share * (t[i + 1] - t[i])), a, b));
  }
  return worst;
}

}  // namespace

void measure_deviation(const std::vector<std::vector<double>>& chain_parameters, ModelParts& parts) {
  Facets& facets = parts.facets;
  const std::vector<bool> pole = pole_nodes(parts);
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto& [a, b, c] = facets.triangles[i];
    const int face = facets.face[i];
    const double d = facet_deviation(*parts.surfaces[face], facets.uv[i], facets.nodes[a], facets.nodes[b],
                                     facets.nodes[c], pole[a] || pole[b] || pole[c]);
    facets.deviation[face] = std::max(facets.deviation[face], kInflate * d);
  }
  for (std::size_t e = 1; e < parts.edges.size(); ++e) {
    if (!parts.curves[e]) continue;
    static const std::vector<double> kNoInner;
    const auto& inner = e < chain_parameters.size() ? chain_parameters[e] : kNoInner;
    facets.edge_deviation[e] = kInflate * chain_deviation(*parts.curves[e], parts.edges[e], inner);
  }
}

}  // namespace octet
