// SPDX-License-Identifier: BSD-3-Clause
// Gathering octant edges once each.
#include "octree/octant_edges.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>

namespace octet {
namespace {

/// From, middle and to of the twelve edges, as places of the octant's 3x3x3 lattice.
constexpr std::array<std::array<std::uint8_t, 3>, 12> edge_places() {
  std::array<std::array<std::uint8_t, 3>, 12> places{};
  constexpr std::array<int, 3> kStride{1, 3, 9};
  int edge = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 4; ++side, ++edge) {
      const int from = 2 * (side & 1) * kStride[(axis + 1) % 3] + 2 * (side >> 1) * kStride[(axis + 2) % 3];
      for (int step = 0; step < 3; ++step) {
        places[edge][step] = static_cast<std::uint8_t>(from + step * kStride[axis]);
      }
    }
  }
  return places;
}

}  // namespace

std::vector<OctantEdge> boundary_octant_edges(const Octree& tree, const OctreeVertices& vertices,
                                              const OctantTypes& types) {
  static constexpr auto kPlaces = edge_places();
  std::vector<OctantEdge> edges;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (types.type[i] != OctantType::kBoundary) continue;
    const OctantLattice lattice = octant_lattice(tree, vertices, OctantId(i));
    for (const auto& [from, middle, to] : kPlaces) {
      if (lattice[middle] == kNoVertex) {
        edges.push_back({lattice[from], lattice[to]});
      } else {
        edges.push_back({lattice[from], lattice[middle]});
        edges.push_back({lattice[middle], lattice[to]});
      }
    }
  }
  tbb::parallel_sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace octet
