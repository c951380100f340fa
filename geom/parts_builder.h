// SPDX-License-Identifier: BSD-3-Clause
// Puts ModelParts together entity by entity, facets welded by topology.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "geom/axes3.h"
#include "geom/model.h"

namespace octet {

/// Tags are given in the order of addition. finish() fills in the adjacency, the lengths and the measured
/// deviations.
class PartsBuilder {
 public:
  PartsBuilder();

  [[nodiscard]] int add_vertex(const Vec3& point);
  /// An edge along `curve`, its polyline in `spans` equal steps of the parameter.
  [[nodiscard]] int add_edge(std::shared_ptr<const Curve> curve, std::array<int, 2> vertex, double t0,
                             double t1, int spans, EdgeUse use = EdgeUse::kReal);
  /// A pole or apex.
  [[nodiscard]] int add_degenerate_edge(int vertex);
  [[nodiscard]] int add_face(std::shared_ptr<const Surface> surface, std::shared_ptr<const Trim> trim,
                             ModelFace face);
  int add_region(double volume);

  [[nodiscard]] std::uint32_t add_node(const Vec3& point);
  [[nodiscard]] std::uint32_t vertex_node(int vertex) const { return vertex_node_[vertex]; }
  /// Nodes of the edge's polyline, from its start to its end.
  [[nodiscard]] const std::vector<std::uint32_t>& edge_nodes(int edge) const { return edge_nodes_[edge]; }
  /// A triangle whose corners run counter-clockwise in (u,v); dropped when two corners are one node.
  void add_triangle(int face, std::array<std::uint32_t, 3> nodes, std::array<Vec2, 3> uv);

  [[nodiscard]] ModelParts finish();

 private:
  void link_entities();
  void measure_faces();
  void measure_edges();

  ModelParts parts_;
  std::vector<std::uint32_t> vertex_node_;
  std::vector<std::vector<std::uint32_t>> edge_nodes_;
};

}  // namespace octet
