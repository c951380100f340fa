// SPDX-License-Identifier: BSD-3-Clause
// A mesh as a file gives it: with the file's own tags, in the file's order.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// Elements of one dimension.
template <std::size_t N>
struct RawElements {
  std::vector<std::uint64_t> tag;
  std::vector<std::int32_t> on;
  std::vector<std::array<std::uint64_t, N>> nodes;  ///< node tags

  void add(std::uint64_t element_tag, std::int32_t entity, const std::uint64_t* node_tags) {
    tag.push_back(element_tag);
    on.push_back(entity);
    auto& element = nodes.emplace_back();
    for (std::size_t i = 0; i < N; ++i) element[i] = node_tags[i];
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
/// left as they are. InputError on tags given twice, unknown nodes, and coordinates that are not finite.
[[nodiscard]] Mesh assemble_mesh(RawMesh&& raw);

}  // namespace octet
