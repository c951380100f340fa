// SPDX-License-Identifier: BSD-3-Clause
// A mesh as a file gives it: with the file's own tags, in the file's order.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// Elements of one dimension, of first or of second order.
template <std::size_t N>
struct RawElements {
  static constexpr std::size_t kSides = N * (N - 1) / 2;
  using Mids = std::array<std::uint64_t, kSides>;

  std::vector<std::uint64_t> tag;
  std::vector<std::int32_t> on;
  std::vector<std::array<std::uint64_t, N>> nodes;  ///< node tags of the corners
  std::vector<Mids> mids;  ///< and of the middles of the edges, in the order of MidNodes; empty: first order

  void add(std::uint64_t element_tag, std::int32_t entity, const std::uint64_t* node_tags) {
    tag.push_back(element_tag);
    on.push_back(entity);
    auto& element = nodes.emplace_back();
    for (std::size_t i = 0; i < N; ++i) element[i] = node_tags[i];
  }
  /// An element of second order: corners, then the middles of its edges, of which the k-th is in the middle
  /// of edge place(k).
  template <class Place>
  void add_second(std::uint64_t element_tag, std::int32_t entity, const std::uint64_t* node_tags,
                  const Place& place) {
    add(element_tag, entity, node_tags);
    auto& own = mids.emplace_back();
    for (std::size_t k = 0; k < kSides; ++k) own[place(k)] = node_tags[N + k];
  }
};

/// A view of post-processing: values at nodes, of elements, or at the nodes of elements.
struct RawView {
  enum class On { kNodes, kElements, kElementNodes };
  std::string name;
  On on = On::kElements;
  int components = 1;
  std::vector<std::uint64_t> tag;  ///< of the node or element
  std::vector<double> value;       ///< per tag: the first component, of an element's nodes the smallest
};

struct RawMesh {
  std::vector<std::uint64_t> node_tag;
  std::vector<Vec3> points;
  std::vector<ModelRef> point_on;  ///< dim -1 where the file does not tell
  RawElements<1> vertices;
  RawElements<2> edges;
  RawElements<3> triangles;
  RawElements<4> tets;
  std::vector<RawView> views;
};

/// Nodes and elements in ascending order of their tags, node tags turned into indices. Nodes of unknown
/// entity get that of the element of least dimension that names them; without any, {3, 0}. Orientations are
/// left as they are. InputError on tags given twice, unknown nodes, coordinates that are not finite, elements
/// of both orders, and nodes that are a corner and in the middle of an edge.
[[nodiscard]] Mesh assemble_mesh(RawMesh&& raw);

}  // namespace octet
