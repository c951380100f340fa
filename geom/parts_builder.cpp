// SPDX-License-Identifier: BSD-3-Clause
// Puts ModelParts together entity by entity.
#include "geom/parts_builder.h"

#include <algorithm>
#include <utility>

#include "base/sort_unique.h"
#include "geom/arc_length.h"

namespace octet {
namespace {

/// Deviations are sampled; the factor covers what lies between the samples.
constexpr double kInflation = 1.5;

}  // namespace

PartsBuilder::PartsBuilder() : vertex_node_(1), edge_nodes_(1) {
  parts_.vertices.resize(1);
  parts_.edges.resize(1);
  parts_.faces.resize(1);
  parts_.regions.resize(1);
  parts_.curves.resize(1);
  parts_.surfaces.resize(1);
  parts_.trims.resize(1);
}

int PartsBuilder::add_vertex(const Vec3& point) {
  ModelVertex vertex;
  vertex.point = point;
  parts_.vertices.push_back(vertex);
  vertex_node_.push_back(add_node(point));
  return static_cast<int>(parts_.vertices.size()) - 1;
}

int PartsBuilder::add_edge(std::shared_ptr<const Curve> curve, std::array<int, 2> vertex, double t0,
                           double t1, int spans, EdgeUse use) {
  ModelEdge edge;
  edge.vertex = vertex;
  edge.t0 = t0;
  edge.t1 = t1;
  edge.use = use;
  edge.length = ArcLength(*curve, t0, t1).total();
  std::vector<std::uint32_t> nodes{vertex_node_[vertex[0]]};
  for (int i = 1; i < spans; ++i) nodes.push_back(add_node(curve->point(t0 + (t1 - t0) * i / spans)));
  nodes.push_back(vertex_node_[vertex[1]]);
  edge_nodes_.push_back(std::move(nodes));
  parts_.edges.push_back(edge);
  parts_.curves.push_back(std::move(curve));
  return static_cast<int>(parts_.edges.size()) - 1;
}

int PartsBuilder::add_degenerate_edge(int vertex) {
  ModelEdge edge;
  edge.vertex = {vertex, vertex};
  edge.t1 = kTwoPi;
  edge.use = EdgeUse::kDegenerate;
  edge_nodes_.push_back({vertex_node_[vertex]});
  parts_.edges.push_back(edge);
  parts_.curves.push_back(nullptr);
  return static_cast<int>(parts_.edges.size()) - 1;
}

int PartsBuilder::add_face(std::shared_ptr<const Surface> surface, std::shared_ptr<const Trim> trim,
                           ModelFace face) {
  parts_.faces.push_back(std::move(face));
  parts_.surfaces.push_back(std::move(surface));
  parts_.trims.push_back(std::move(trim));
  return static_cast<int>(parts_.faces.size()) - 1;
}

int PartsBuilder::add_region(double volume) {
  ModelRegion region;
  region.volume = volume;
  parts_.regions.push_back(region);
  return static_cast<int>(parts_.regions.size()) - 1;
}

std::uint32_t PartsBuilder::add_node(const Vec3& point) {
  parts_.facets.nodes.push_back(point);
  return static_cast<std::uint32_t>(parts_.facets.nodes.size() - 1);
}

void PartsBuilder::add_triangle(int face, std::array<std::uint32_t, 3> nodes, std::array<Vec2, 3> uv) {
  if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) return;
  if (parts_.faces[face].reversed) {
    std::swap(nodes[1], nodes[2]);
    std::swap(uv[1], uv[2]);
  }
  parts_.facets.triangles.push_back(nodes);
  parts_.facets.uv.push_back(uv);
  parts_.facets.face.push_back(face);
}

ModelParts PartsBuilder::finish() {
  link_entities();
  measure_faces();
  measure_edges();
  return std::move(parts_);
}

void PartsBuilder::link_entities() {
  for (std::size_t e = 1; e < parts_.edges.size(); ++e)
    for (const int v : parts_.edges[e].vertex) parts_.vertices[v].edges.push_back(static_cast<int>(e));
  for (std::size_t f = 1; f < parts_.faces.size(); ++f) {
    ModelFace& face = parts_.faces[f];
    for (const FaceBoundary& b : face.boundary) {
      parts_.edges[b.edge].faces.push_back(static_cast<int>(f));
      for (const int v : parts_.edges[b.edge].vertex) face.vertices.push_back(v);
    }
    sort_unique(face.vertices);
    for (const int r : face.region)
      if (r > 0) parts_.regions[r].faces.push_back(static_cast<int>(f));
  }
  for (ModelVertex& vertex : parts_.vertices) sort_unique(vertex.edges);
  for (ModelEdge& edge : parts_.edges) sort_unique(edge.faces);
  for (ModelRegion& region : parts_.regions) sort_unique(region.faces);
}

void PartsBuilder::measure_faces() {
  Facets& facets = parts_.facets;
  facets.deviation.assign(parts_.faces.size(), 0.0);
  constexpr int kSteps = 4;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto& t = facets.triangles[i];
    double& worst = facets.deviation[facets.face[i]];
    for (int a = 0; a <= kSteps; ++a)
      for (int b = 0; a + b <= kSteps; ++b) {
        const Vec3 w = Vec3(a, b, kSteps - a - b) / kSteps;
        const Vec3 p = w[0] * facets.nodes[t[0]] + w[1] * facets.nodes[t[1]] + w[2] * facets.nodes[t[2]];
        const Vec2 seed = w[0] * facets.uv[i][0] + w[1] * facets.uv[i][1] + w[2] * facets.uv[i][2];
        worst = std::max(worst, (parts_.surfaces[facets.face[i]]->project(p, seed).point - p).norm());
      }
  }
  for (double& d : facets.deviation) d *= kInflation;
}

void PartsBuilder::measure_edges() {
  const Facets& facets = parts_.facets;
  parts_.facets.edge_deviation.assign(parts_.edges.size(), 0.0);
  constexpr int kSteps = 8;
  for (std::size_t e = 1; e < parts_.edges.size(); ++e) {
    if (!parts_.curves[e]) continue;
    const ModelEdge& edge = parts_.edges[e];
    const auto& nodes = edge_nodes_[e];
    const double step = (edge.t1 - edge.t0) / static_cast<double>(nodes.size() - 1);
    double& worst = parts_.facets.edge_deviation[e];
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const Vec3 &a = facets.nodes[nodes[i]], &b = facets.nodes[nodes[i + 1]];
      for (int k = 1; k < kSteps; ++k) {
        const Vec3 x =
            parts_.curves[e]->point(edge.t0 + step * (static_cast<double>(i) + k / double{kSteps}));
        const double u = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        worst = std::max(worst, (x - a - u * (b - a)).norm());
      }
    }
    worst *= kInflation;
  }
}

}  // namespace octet
