// SPDX-License-Identifier: BSD-3-Clause
// Tags are mostly a permutation of 1..n; a table serves those, a binary search any other.
#include "io/raw_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

constexpr auto kNoNode = std::numeric_limits<std::uint32_t>::max();

/// The order that sorts the tags.
std::vector<std::uint32_t> order_of(const std::vector<std::uint64_t>& tags, const char* what) {
  if (tags.size() >= kNoNode) throw InputError(fmt::format("too many {}s", what));
  std::vector<std::uint32_t> order(tags.size());
  std::iota(order.begin(), order.end(), 0u);
  if (!std::is_sorted(tags.begin(), tags.end()))
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return tags[a] < tags[b]; });
  return order;
}

void check_distinct(const std::vector<std::uint64_t>& sorted_tags, const char* what) {
  const auto twice = std::adjacent_find(sorted_tags.begin(), sorted_tags.end());
  if (twice != sorted_tags.end()) throw InputError(fmt::format("{} {} is given twice", what, *twice));
}

template <class T>
std::vector<T> in_order(const std::vector<T>& items, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted;
  sorted.reserve(items.size());
  for (const std::uint32_t i : order) sorted.push_back(items[i]);
  return sorted;
}

class NodeIndex {
 public:
  explicit NodeIndex(const std::vector<std::uint64_t>& sorted_tags) : tags_(sorted_tags) {
    if (tags_.empty() || tags_.back() > 4 * tags_.size() + 1024) return;
    table_.assign(tags_.back() + 1, kNoNode);
    for (std::size_t i = 0; i < tags_.size(); ++i) table_[tags_[i]] = static_cast<std::uint32_t>(i);
  }
  [[nodiscard]] std::uint32_t of(std::uint64_t tag) const {
    std::uint32_t index = kNoNode;
    if (!table_.empty()) {
      if (tag < table_.size()) index = table_[tag];
    } else {
      const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
      if (at != tags_.end() && *at == tag) index = static_cast<std::uint32_t>(at - tags_.begin());
    }
    if (index == kNoNode) throw InputError(fmt::format("an element names node {}, which is not given", tag));
    return index;
  }

 private:
  const std::vector<std::uint64_t>& tags_;
  std::vector<std::uint32_t> table_;
};

/// Elements with their nodes by index.
template <std::size_t N>
struct Placed {
  std::vector<std::array<Mesh::Index, N>> corners;
  std::vector<std::int32_t> on;
  std::vector<std::array<Mesh::Index, RawElements<N>::kSides>> mids;  ///< empty: first order
};

template <std::size_t N>
Placed<N> place_elements(const RawElements<N>& raw, const NodeIndex& index) {
  if (!raw.mids.empty() && raw.mids.size() != raw.nodes.size())
    throw InputError("the file has elements of first and of second order");
  const auto order = order_of(raw.tag, "element");
  Placed<N> placed;
  placed.corners.reserve(order.size());
  placed.on.reserve(order.size());
  placed.mids.reserve(raw.mids.size());
  for (const std::uint32_t i : order) {
    auto& element = placed.corners.emplace_back();
    for (std::size_t k = 0; k < N; ++k) element[k] = index.of(raw.nodes[i][k]);
    placed.on.push_back(raw.on[i]);
    if (raw.mids.empty()) continue;
    auto& mids = placed.mids.emplace_back();
    for (std::size_t k = 0; k < mids.size(); ++k) mids[k] = index.of(raw.mids[i][k]);
  }
  return placed;
}

template <std::size_t N>
void spread_entities(int dim, const std::vector<std::array<Mesh::Index, N>>& elements,
                     const std::vector<std::int32_t>& on, std::vector<ModelRef>& point_on) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Mesh::Index v : elements[i])
      if (point_on[v].dim < 0) point_on[v] = {dim, on[i]};
}

constexpr int kEdgeSide[1][2] = {{0, 1}};
constexpr int kTriangleSide[3][2] = {{0, 1}, {1, 2}, {2, 0}};

/// Takes the nodes in the middles of edges out of the mesh's points. Until then both have one numbering.
class MidNodeTaker {
 public:
  MidNodeTaker(Mesh& mesh, const std::vector<std::uint64_t>& tags)
      : mesh_(mesh), tags_(tags), is_mid_(mesh.points.size(), 0), number_(mesh.points.size(), kNoNode) {}

  template <std::size_t N>
  void flag(const Placed<N>& placed) {
    if (placed.mids.size() != placed.corners.size())
      throw InputError("the file has elements of first and of second order");
    for (const auto& element : placed.mids)
      for (const Mesh::Index m : element) is_mid_[m] = 1;
  }
  /// Once all are flagged.
  void take() {
    std::size_t kept = 0;
    MidNodes& mid = mesh_.mid;
    for (std::size_t v = 0; v < is_mid_.size(); ++v) {
      if (is_mid_[v] != 0) {
        number_[v] = static_cast<Mesh::Index>(mid.points.size());
        mid.points.push_back(mesh_.points[v]);
        mid.on.push_back(mesh_.point_on[v]);
      } else {
        number_[v] = static_cast<Mesh::Index>(kept);
        mesh_.points[kept] = mesh_.points[v];
        mesh_.point_on[kept++] = mesh_.point_on[v];
      }
    }
    mesh_.points.resize(kept);
    mesh_.point_on.resize(kept);
    mid.between.resize(mid.points.size(), {kNoNode, kNoNode});
  }
  /// Once they are taken.
  template <std::size_t N, std::size_t Sides>
  void renumber(Placed<N>& placed, const int (&side)[Sides][2]) {
    for (std::size_t i = 0; i < placed.corners.size(); ++i) {
      for (Mesh::Index& v : placed.corners[i]) {
        if (is_mid_[v] != 0)
          throw InputError(fmt::format("node {} is a corner and in the middle of an edge", tags_[v]));
        v = number_[v];
      }
      for (std::size_t k = 0; k < Sides; ++k) {
        Mesh::Index& m = placed.mids[i][k];
        m = number_[m];
        const Mesh::Index a = placed.corners[i][static_cast<std::size_t>(side[k][0])],
                          b = placed.corners[i][static_cast<std::size_t>(side[k][1])];
        if (mesh_.mid.between[m][0] == kNoNode) mesh_.mid.between[m] = {std::min(a, b), std::max(a, b)};
      }
    }
  }

 private:
  Mesh& mesh_;
  const std::vector<std::uint64_t>& tags_;
  std::vector<std::uint8_t> is_mid_;
  std::vector<Mesh::Index> number_;  ///< of each node, among its own kind
};

void take_mid_nodes(Mesh& mesh, const std::vector<std::uint64_t>& tags, Placed<2>& edges,
                    Placed<3>& triangles, Placed<4>& tets) {
  MidNodeTaker taker(mesh, tags);
  taker.flag(edges);
  taker.flag(triangles);
  taker.flag(tets);
  taker.take();
  taker.renumber(edges, kEdgeSide);
  taker.renumber(triangles, kTriangleSide);
  taker.renumber(tets, kTetEdge);
  for (const auto& mids : edges.mids) mesh.mid.of_edges.push_back(mids[0]);
  mesh.mid.of_triangles = std::move(triangles.mids);
  mesh.mid.of_tets = std::move(tets.mids);
}

}  // namespace

Mesh assemble_mesh(RawMesh&& raw) {
  const auto order = order_of(raw.node_tag, "node");
  const auto tags = in_order(raw.node_tag, order);
  check_distinct(tags, "node");
  Mesh mesh;
  mesh.points = in_order(raw.points, order);
  mesh.point_on = in_order(raw.point_on, order);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!mesh.points[v].allFinite())
      throw InputError(fmt::format("node {} has coordinates that are not finite", tags[v]));
  const NodeIndex index(tags);
  const Placed<1> vertices = place_elements(raw.vertices, index);
  Placed<2> edges = place_elements(raw.edges, index);
  Placed<3> triangles = place_elements(raw.triangles, index);
  Placed<4> tets = place_elements(raw.tets, index);
  spread_entities(0, vertices.corners, vertices.on, mesh.point_on);
  spread_entities(1, edges.corners, edges.on, mesh.point_on);
  spread_entities(2, triangles.corners, triangles.on, mesh.point_on);
  spread_entities(3, tets.corners, tets.on, mesh.point_on);
  spread_entities(1, edges.mids, edges.on, mesh.point_on);
  spread_entities(2, triangles.mids, triangles.on, mesh.point_on);
  spread_entities(3, tets.mids, tets.on, mesh.point_on);
  for (ModelRef& ref : mesh.point_on)
    if (ref.dim < 0) ref = {3, 0};
  mesh.edge_on = std::move(edges.on);
  mesh.triangle_on = std::move(triangles.on);
  mesh.tet_in = std::move(tets.on);
  if (!edges.mids.empty() || !triangles.mids.empty() || !tets.mids.empty())
    take_mid_nodes(mesh, tags, edges, triangles, tets);
  mesh.edges = std::move(edges.corners);
  mesh.triangles = std::move(triangles.corners);
  mesh.tets = std::move(tets.corners);
  return mesh;
}

}  // namespace octet
