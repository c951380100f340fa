// SPDX-License-Identifier: BSD-3-Clause
// Which sides of which facets lie on which model edge.
#include "geom/border_sides.h"

#include <algorithm>
#include <tuple>

#include "base/constants.h"
#include "base/sort_unique.h"

namespace octet {
namespace {

/// One use of a facet side by a triangle.
struct SideUse {
  std::uint32_t a, b;  ///< a < b
  std::uint32_t triangle;
  std::uint8_t corner;  ///< opposite the side
};

std::vector<SideUse> side_uses(const Facets& facets) {
  std::vector<SideUse> uses;
  uses.reserve(3 * facets.triangles.size());
  for (std::uint32_t i = 0; i < facets.triangles.size(); ++i)
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint32_t a = facets.triangles[i][(k + 1) % 3], b = facets.triangles[i][(k + 2) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), i, k});
    }
  std::sort(uses.begin(), uses.end(), [](const SideUse& x, const SideUse& y) {
    return std::tie(x.a, x.b, x.triangle, x.corner) < std::tie(y.a, y.b, y.triangle, y.corner);
  });
  return uses;
}

/// Real edges of the face; `slits` only those that have no other face.
std::vector<int> real_edges(const ModelParts& parts, int face, bool slits) {
  std::vector<int> edges;
  for (const FaceBoundary& b : parts.faces[face].boundary) {
    const ModelEdge& edge = parts.edges[b.edge];
    if (edge.use == EdgeUse::kReal && parts.curves[b.edge] && (!slits || edge.faces.size() == 1))
      edges.push_back(b.edge);
  }
  sort_unique(edges);
  return edges;
}

struct EdgeMatch {
  int edge = 0;
  double t = 0.0, distance = kInfinity;
};

/// The edge among `edges` whose curve runs nearest to the side's middle, of those that its ends lie on where
/// there are such: a long chord may come nearer to another edge than to its own, which runs beside it.
EdgeMatch match(const ModelParts& parts, const std::vector<CurveSamples>& samples,
                const std::vector<int>& edges, const Vec3& a, const Vec3& b, double slack) {
  const auto off_ends = [&](int e) {
    if (edges.size() == 1) return 0.0;
    const double off = std::max(samples[e].nearest(*parts.curves[e], a).distance,
                                samples[e].nearest(*parts.curves[e], b).distance);
    return std::max(off - parts.edges[e].tolerance - slack, 0.0);
  };
  EdgeMatch best;
  double least_off = kInfinity;
  for (const int e : edges) {
    const double off = off_ends(e);
    if (off > least_off) continue;
    const CurveFoot foot = samples[e].nearest(*parts.curves[e], 0.5 * (a + b));
    if (off == least_off && foot.distance >= best.distance) continue;
    least_off = off;
    best = {e, foot.t, foot.distance};
  }
  return best;
}

/// A side within a face stands for an edge only when it is a slit: both nodes and the middle lie on it.
bool lies_on(const ModelParts& parts, const EdgeMatch& m, const Vec3& a, const Vec3& b) {
  if (m.edge == 0) return false;
  const Curve& curve = *parts.curves[m.edge];
  const double reach =
      parts.facets.edge_deviation[m.edge] + parts.edges[m.edge].tolerance + 1e-9 * (b - a).norm();
  const auto near = [&](const Vec3& p) { return (curve.point(curve.project(p, m.t)) - p).norm() <= reach; };
  return m.distance <= reach && near(a) && near(b);
}

std::vector<int> common(const std::vector<int>& x, const std::vector<int>& y) {
  std::vector<int> both;
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both));
  return both;
}

std::vector<std::int32_t> vertex_nodes(const ModelParts& parts) {
  // Welded facets hold the vertices' points to the bit, or to the vertex tolerance: nearest node within it.
  const auto& nodes = parts.facets.nodes;
  std::vector<std::int32_t> node_vertex(nodes.size(), 0);
  Box3 box;
  for (const Vec3& n : nodes) box.add(n);
  std::vector<std::uint32_t> by_x(nodes.size());
  for (std::uint32_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
  std::sort(by_x.begin(), by_x.end(), [&](std::uint32_t a, std::uint32_t b) {
    return nodes[a].x() != nodes[b].x() ? nodes[a].x() < nodes[b].x() : a < b;
  });
  for (std::size_t v = 1; v < parts.vertices.size(); ++v) {
    const ModelVertex& vertex = parts.vertices[v];
    const double reach = vertex.tolerance + 1e-9 * box.diagonal();
    auto it = std::lower_bound(by_x.begin(), by_x.end(), vertex.point.x() - reach,
                               [&](std::uint32_t n, double x) { return nodes[n].x() < x; });
    double best = reach;
    std::int64_t node = -1;
    for (; it != by_x.end() && nodes[*it].x() <= vertex.point.x() + reach; ++it) {
      const double d = (nodes[*it] - vertex.point).norm();
      if (d > best || (d == best && node >= 0)) continue;
      best = d;
      node = *it;
    }
    if (node >= 0) node_vertex[node] = static_cast<std::int32_t>(v);
  }
  return node_vertex;
}

/// The chord ends in the points of the model's vertices, which may lie off the curve.
double off_at_ends(const ModelParts& parts, const BorderSides& border, std::uint32_t a, std::uint32_t b,
                   double tolerance) {
  double vertex = 0.0;
  for (const std::uint32_t node : {a, b})
    if (const std::int32_t v = border.node_vertex[node]; v > 0)
      vertex = std::max(vertex, parts.vertices[v].tolerance);
  return tolerance + vertex;
}

}  // namespace

BorderSides find_border_sides(const ModelParts& parts, const std::vector<CurveSamples>& samples,
                              double tolerance) {
  const Facets& facets = parts.facets;
  const std::size_t faces = parts.faces.size();
  std::vector<std::vector<int>> edges(faces), slits(faces);
  for (std::size_t f = 1; f < faces; ++f) {
    edges[f] = real_edges(parts, static_cast<int>(f), false);
    slits[f] = real_edges(parts, static_cast<int>(f), true);
  }
  BorderSides border;
  border.node_vertex = vertex_nodes(parts);
  border.of_triangle.assign(facets.triangles.size(), {-1, -1, -1});
  const std::vector<SideUse> uses = side_uses(facets);
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    std::vector<int> candidates = edges[facets.face[uses[begin].triangle]];
    bool one_face = true;
    for (end = begin; end < uses.size() && uses[end].a == uses[begin].a && uses[end].b == uses[begin].b;
         ++end) {
      const int face = facets.face[uses[end].triangle];
      if (face != facets.face[uses[begin].triangle]) one_face = false;
      candidates = common(candidates, edges[face]);
    }
    if (one_face) candidates = slits[facets.face[uses[begin].triangle]];
    if (candidates.empty()) continue;
    const Vec3 &a = facets.nodes[uses[begin].a], &b = facets.nodes[uses[begin].b];
    const double slack = off_at_ends(parts, border, uses[begin].a, uses[begin].b, tolerance);
    const EdgeMatch m = match(parts, samples, candidates, a, b, slack);
    if (m.edge == 0 || (one_face && !lies_on(parts, m, a, b))) continue;
    for (std::size_t i = begin; i < end; ++i)
      border.of_triangle[uses[i].triangle][uses[i].corner] = static_cast<std::int32_t>(border.sides.size());
    BorderSide side{m.edge, m.t, uses[begin].a, uses[begin].b};
    side.reach = parts.facets.edge_deviation[m.edge] + parts.edges[m.edge].tolerance + slack;
    border.sides.push_back(side);
  }
  return border;
}

std::vector<double> facet_growth(const ModelParts& parts, const BorderSides& border, double tolerance) {
  const Facets& facets = parts.facets;
  std::vector<double> grow(facets.triangles.size());
  for (std::size_t i = 0; i < grow.size(); ++i) {
    const int face = facets.face[i];
    double chord = 0.0, vertex = 0.0;
    for (int k = 0; k < 3; ++k) {
      if (const std::int32_t side = border.of_triangle[i][k]; side >= 0) {
        const int edge = border.sides[side].edge;
        chord = std::max(chord, facets.edge_deviation[edge] + parts.edges[edge].tolerance);
      }
      if (const std::int32_t v = border.node_vertex[facets.triangles[i][k]]; v > 0)
        vertex = std::max(vertex, parts.vertices[v].tolerance);
    }
    grow[i] = facets.deviation[face] + parts.faces[face].tolerance + chord + vertex + 2.0 * tolerance;
  }
  return grow;
}

}  // namespace octet
