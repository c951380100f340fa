// SPDX-License-Identifier: BSD-3-Clause
// Tags are mostly a permutation of 1..n; a table serves those, a binary search any other.
#include "io/raw_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace octet {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

/// The order that sorts the tags.
std::vector<std::uint32_t> order_of(const std::vector<std::uint64_t>& tags, const char* what) {
  if (tags.size() >= kNone) throw InputError(fmt::format("too many {}s", what));
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
    table_.assign(tags_.back() + 1, kNone);
    for (std::size_t i = 0; i < tags_.size(); ++i) table_[tags_[i]] = static_cast<std::uint32_t>(i);
  }
  [[nodiscard]] std::uint32_t of(std::uint64_t tag) const {
    std::uint32_t index = kNone;
    if (!table_.empty()) {
      if (tag < table_.size()) index = table_[tag];
    } else {
      const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
      if (at != tags_.end() && *at == tag) index = static_cast<std::uint32_t>(at - tags_.begin());
    }
    if (index == kNone) throw InputError(fmt::format("an element names node {}, which is not given", tag));
    return index;
  }

 private:
  const std::vector<std::uint64_t>& tags_;
  std::vector<std::uint32_t> table_;
};

template <std::size_t N>
void place_elements(const RawElements<N>& raw, const NodeIndex& index,
                    std::vector<std::array<Mesh::Index, N>>& elements, std::vector<std::int32_t>& on) {
  const auto order = order_of(raw.tag, "element");
  elements.reserve(order.size());
  on.reserve(order.size());
  for (const std::uint32_t i : order) {
    auto& element = elements.emplace_back();
    for (std::size_t k = 0; k < N; ++k) element[k] = index.of(raw.nodes[i][k]);
    on.push_back(raw.on[i]);
  }
}

template <std::size_t N>
void spread_entities(int dim, const std::vector<std::array<Mesh::Index, N>>& elements,
                     const std::vector<std::int32_t>& on, std::vector<ModelRef>& point_on) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Mesh::Index v : elements[i])
      if (point_on[v].dim < 0) point_on[v] = {dim, on[i]};
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
  std::vector<std::array<Mesh::Index, 1>> vertices;
  std::vector<std::int32_t> vertex_on;
  place_elements(raw.vertices, index, vertices, vertex_on);
  place_elements(raw.edges, index, mesh.edges, mesh.edge_on);
  place_elements(raw.triangles, index, mesh.triangles, mesh.triangle_on);
  place_elements(raw.tets, index, mesh.tets, mesh.tet_in);
  spread_entities(0, vertices, vertex_on, mesh.point_on);
  spread_entities(1, mesh.edges, mesh.edge_on, mesh.point_on);
  spread_entities(2, mesh.triangles, mesh.triangle_on, mesh.point_on);
  spread_entities(3, mesh.tets, mesh.tet_in, mesh.point_on);
  for (ModelRef& ref : mesh.point_on)
    if (ref.dim < 0) ref = {3, 0};
  return mesh;
}

}  // namespace octet
